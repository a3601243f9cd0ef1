#include "light/pieces.h"

#include <algorithm>

namespace shadow_planes {

Piece Pieces::add(const std::vector<moire::Point>& corners) {
  const std::size_t first = room(corners.size());
  std::copy(corners.begin(), corners.end(), corners_.begin() + static_cast<std::ptrdiff_t>(first));
  used_ += corners.size();
  return {first, corners.size()};
}

void Pieces::cut(Piece piece, const Line& line, double tolerance, Piece* within, Piece* beyond) {
  // A convex piece that rounding bends may be cut more than twice; each cut adds a corner to either part.
  const std::size_t longest = 2 * piece.count;
  const std::size_t inner = room(2 * longest), outer = inner + longest;
  moire::Point* const corners = corners_.data();
  std::size_t inside = 0, outside = 0;
  moire::Point p = corners[piece.first + piece.count - 1];
  double at_p = line(p);
  for (std::size_t k = piece.first; k < piece.first + piece.count; ++k) {
    const moire::Point q = corners[k];
    const double at_q = line(q);
    if ((at_p > tolerance && at_q < -tolerance) || (at_p < -tolerance && at_q > tolerance)) {
      // From the same end whichever way the edge runs, so that neighbours meet to the bit.
      const moire::Point& from = at_p > 0 ? p : q;
      const moire::Point& to = at_p > 0 ? q : p;
      const double share = at_p > 0 ? at_p / (at_p - at_q) : at_q / (at_q - at_p);
      const moire::Point on{from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
      corners[inner + inside++] = on;
      corners[outer + outside++] = on;
    }
    if (at_q >= -tolerance) corners[inner + inside++] = q;
    if (at_q <= tolerance) corners[outer + outside++] = q;
    p = q;
    at_p = at_q;
  }
  *within = {inner, inside};
  if (beyond) {
    *beyond = {outer, outside};
    used_ = outer + outside;
  } else {
    used_ = inner + inside;
  }
}

}  // namespace shadow_planes
