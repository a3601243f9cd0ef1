// What chains are within one row of pixels.
#pragma once

#include <cstdint>

#include <moire/geometry.h>

namespace area {

// A point of a chain in a row: y in 0 .. 1 from the row's top, x in the image; `source` is the chain's point after
// which it comes.
struct PathPoint {
  double x, y;
  std::uint32_t source;
};

// x where an edge is at y. From its upper end, whoever it belongs to, so that edges that coincide do so to the bit.
// Requires: p.y <= y <= q.y, p.y < q.y.
template <class Point>
double x_at(const Point& p, const Point& q, double y) {
  if (y == q.y) return q.x;
  return p.x + (y - p.y) * ((q.x - p.x) / (q.y - p.y));
}

}  // namespace area
