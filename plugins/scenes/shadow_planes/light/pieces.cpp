#include "light/pieces.h"

#include <algorithm>

namespace shadow_planes {

Piece Pieces::add(const std::vector<moire::Point>& corners) {
  const std::size_t first = room(corners.size());
  std::copy(corners.begin(), corners.end(), corners_.begin() + static_cast<std::ptrdiff_t>(first));
  used_ += corners.size();
  return {first, corners.size()};
}

Side Pieces::divide(Piece& piece, const BorderLine& border, Piece* beyond) {
  const std::size_t count = piece.count;
  if (values_.size() < count) values_.resize(2 * count);
  const double tolerance = border.tolerance;
  bool some_within = false, some_beyond = false;
  for (std::size_t k = 0; k < count; ++k) {
    const double value = values_[k] = border.line(corners_[piece.first + k]);
    some_within |= value > tolerance;
    some_beyond |= value < -tolerance;
  }
  if (!some_within) return Side::beyond;
  if (!some_beyond) return Side::within;
  // A convex piece that rounding bends may be cut more than twice; each cut adds a corner to either part.
  const std::size_t inner = room(4 * count), outer = inner + 2 * count;
  const moire::Point* const corners = corners_.data() + piece.first;
  moire::Point* const inside = corners_.data() + inner;
  moire::Point* const outside = corners_.data() + outer;
  std::size_t inside_count = 0, outside_count = 0;
  std::size_t before = count - 1;
  for (std::size_t k = 0; k < count; before = k++) {
    const double at_p = values_[before], at_q = values_[k];
    const moire::Point &p = corners[before], &q = corners[k];
    if ((at_p > tolerance && at_q < -tolerance) || (at_p < -tolerance && at_q > tolerance)) {
      // From the same end whichever way the edge runs, so that neighbours meet to the bit.
      const moire::Point& from = at_p > 0 ? p : q;
      const moire::Point& to = at_p > 0 ? q : p;
      const double share = at_p > 0 ? at_p / (at_p - at_q) : at_q / (at_q - at_p);
      const moire::Point on{from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
      inside[inside_count++] = on;
      if (beyond) outside[outside_count++] = on;
    }
    if (at_q >= -tolerance) inside[inside_count++] = q;
    if (beyond && at_q <= tolerance) outside[outside_count++] = q;
  }
  piece = {inner, inside_count};
  if (beyond) *beyond = {outer, outside_count};
  used_ = beyond ? outer + outside_count : inner + inside_count;
  return Side::cut;
}

}  // namespace shadow_planes
