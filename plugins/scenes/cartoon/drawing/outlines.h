// A drawing whose curves have become straight lines, fine enough for one range of scales.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <moire/frame.h>

#include "drawing.h"

namespace cartoon {

// Which numbers averages are taken of, so what colours are.
moire::Color color_of(Rgb code, moire::Blend blend);

class Outlines {
 public:
  struct Layer {
    std::size_t first_point, first_contour;  // those of the next layer are the end
    moire::Color color;
    moire::FillRule rule;
  };

  // No point of a chord is farther than `tolerance` from its curve. Error: too many points.
  Outlines(const Drawing& drawing, double tolerance, moire::Blend blend);

  // Of no other outlines in this process.
  std::uint64_t identity() const { return identity_; }

  std::size_t layers() const { return layers_.size() - 1; }
  const Layer& layer(std::size_t k) const { return layers_[k]; }
  // In the coordinates of the drawing, layer by layer.
  std::span<const moire::Point> points() const { return points_; }
  std::span<const std::uint32_t> contours(std::size_t k) const {
    return std::span(contours_).subspan(layers_[k].first_contour,
                                        layers_[k + 1].first_contour - layers_[k].first_contour);
  }
  std::size_t point_end(std::size_t k) const { return layers_[k + 1].first_point; }

  // Layer k with its points taken from `points`, in the order of points(): element k + 1.
  moire::Polygon polygon(std::size_t k, std::span<const moire::Point> points) const {
    return {k + 1, layers_[k].color, layers_[k].rule,
            points.subspan(layers_[k].first_point, point_end(k) - layers_[k].first_point), contours(k)};
  }

 private:
  void finish_contour(std::size_t first_point);

  std::uint64_t identity_;
  std::vector<Layer> layers_;  // and an end
  std::vector<moire::Point> points_;
  std::vector<std::uint32_t> contours_;  // indices of first points, from the layer's first point
};

}  // namespace cartoon
