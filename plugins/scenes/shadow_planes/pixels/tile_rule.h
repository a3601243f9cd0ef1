// Averages over the pixels of a square tile from values at the points of a Gauss grid over it: the polynomial through
// them is integrated over each pixel.
#pragma once

#include <array>
#include <span>
#include <vector>

namespace shadow_planes {

class TileRule {
 public:
  // Points along each side; pixels along each side.
  TileRule(int points, int side);

  int points() const { return points_; }
  int side() const { return side_; }
  // Of a point along a side, in pixels.
  double at(int point) const { return at_[static_cast<std::size_t>(point)]; }

  // values[j * points + i] belongs to the point (at(i), at(j)); averages[y * side + x] to a pixel.
  void averages(std::span<const double> values, std::span<double> averages) const;

  // How much of the function the polynomial may leave out, by how its Legendre coefficients fall: geometrically if the
  // function is smooth, and if it is not (`is_smooth` false, or they do not fall) no better than the last of them.
  double error(std::span<const double> values, bool is_smooth) const;

 private:
  int points_, side_;
  std::vector<double> at_;
  std::vector<double> pixel_weights_;  // [x * points + i]
  std::vector<double> coefficients_;   // [k * points + i]
};

// The rule for tiles of 2, 4, 8, 16 pixels a side.
const TileRule& tile_rule(int side);

}  // namespace shadow_planes
