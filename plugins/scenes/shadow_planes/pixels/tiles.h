// The work of one call: a block of pixels, tile by tile. What a pixel gets depends on its tile alone, of which there
// may be more than the block wants.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "pixels/piece_integral.h"
#include "pixels/shaded_face.h"
#include "seeing/visible_parts.h"

namespace shadow_planes {

class Tiles {
 public:
  static constexpr int side = 16;
  static int rounded_up(int length) { return (length + side - 1) / side * side; }

  Tiles(const VisibleParts& visible, const std::vector<std::unique_ptr<const ShadedFace>>& faces, moire::Color sky,
        bool is_flat, moire::PixelBlock& block)
      : visible_(visible), faces_(faces), sky_(sky), block_(block), gatherer_(is_flat, block.recording()) {}

  // Fills the block; a bound on the error of a channel, from estimates.
  double integrate();

 private:
  using Candidates = std::span<const std::uint32_t>;
  // A square of 1, 2, 4, 8 or 16 pixels a side.
  struct Tile {
    int x, y, side;
    moire::Rectangle window() const {
      return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(x + side),
              static_cast<double>(y + side)};
    }
  };
  // By whom how much of a pixel is shadowed: pairs of face and weight, faces rising.
  using Shadows = std::vector<std::pair<std::uint32_t, double>>;

  bool is_wanted(const Tile& tile) const;
  template <class Each>
  static void for_quarters(const Tile& tile, Each each);

  void any_faces(const Tile& tile);
  void one_face(const Tile& tile, const ShadedFace& face, Candidates candidates, int depth);
  bool interpolate(const Tile& tile, const ShadedFace& face, Candidates candidates);
  void mixed_pixel(const Tile& tile);
  Integral integral(const Outline& outline, const Tile& pixel, const ShadedFace& face, Candidates candidates);
  void cut(const ImageSegment& segment);

  void deposit(std::size_t slot, const ShadedFace& face, double area, Sums sums, const Shadows& shadows);
  void collect_shadows(std::size_t mark, double factor);
  // Work is counted in the block that has the tile's first pixel.
  void count(const Tile& tile);

  const VisibleParts& visible_;
  const std::vector<std::unique_ptr<const ShadedFace>>& faces_;
  moire::Color sky_;
  moire::PixelBlock& block_;
  Gatherer gatherer_;
  std::uint64_t counted_ = 0;  // points
  double error_ = 0;

  std::vector<Part> parts_;
  std::array<std::vector<std::uint32_t>, 6> candidates_;  // by depth
  std::vector<std::uint32_t> met_;
  Shadows shadows_;
  // Of a pixel; the first `pieces_count_` are in use.
  std::vector<Outline> pieces_;
  std::size_t pieces_count_ = 0;
  Outline within_, beyond_;
  // Of a tile: of each quantity the values at the points, and the averages of the pixels.
  std::vector<std::uint32_t> shadowing_;
  std::vector<std::vector<double>> values_, averages_;
};

}  // namespace shadow_planes
