// The points of one image column, sorted into strands: batches that a scene can answer one from another.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <moire/sampler.h>

#include "sampling/light_lattice.h"

namespace moire {

// Points that share x, or that lie in one upright strip of the pixels, from the bottom of the image to its top.
struct Strand {
  std::vector<SamplePoint> points;
  std::vector<std::uint32_t> rows;  // the pixel of each point: y from the block's top
  std::vector<double> offsets;      // of each point's x from its pixel
  std::vector<double> weights;      // of a pixel, over all strands: their sum is 1
  std::vector<Point> places;        // in its pixel, of each point before it was moved; of strands with places
};

class Strands {
 public:
  // Of pixels (x, y0) .. (x, y0 + height - 1). `light_seed`: with points of the light. Error: the sampler gave no
  // points, points outside the pixel or the light, or weights that cannot be divided by their sum.
  Strands(const PointSampler& sampler, Pixel pixel, int y0, int height, LightSeed light_seed = {})
      : Strands(sampler, pixel, y0, height, light_seed, {}) {}
  // With places. Points and places go to the left and upward by `shift`.
  static Strands with_places(const PointSampler& sampler, Pixel pixel, int y0, int height, LightSeed light_seed,
                             Point shift) {
    return {sampler, pixel, y0, height, light_seed, shift};
  }

  std::vector<Strand>& all() { return strands_; }
  const std::vector<Strand>& all() const { return strands_; }

  // Moves all points to image column x. For samplers whose points are the same in every pixel, without a light.
  void move_to(int x);

 private:
  // To so many strands, which will hold so many points in all, about evenly.
  void grow(std::size_t count, std::size_t points);

  Strands(const PointSampler& sampler, Pixel pixel, int y0, int height, LightSeed light_seed,
          std::optional<Point> shift);

  std::vector<Strand> strands_;
};

}  // namespace moire
