// The area of convex polygons in a pixel by clipping, with 64 bits of mantissa: what closed forms are held to.
#pragma once

#include <functional>
#include <vector>

namespace moire::test {

struct LongPoint {
  long double x, y;
};
using LongPolygon = std::vector<LongPoint>;

// What is left where inside(p) >= 0, which is linear in p (Sutherland and Hodgman 1974).
inline LongPolygon clipped(const LongPolygon& polygon, const std::function<long double(LongPoint)>& inside) {
  LongPolygon result;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const LongPoint p = polygon[k], q = polygon[(k + 1) % polygon.size()];
    const long double a = inside(p), b = inside(q);
    if (a >= 0) result.push_back(p);
    if ((a < 0) != (b < 0)) result.push_back({p.x + (q.x - p.x) * (a / (a - b)), p.y + (q.y - p.y) * (a / (a - b))});
  }
  return result;
}

inline LongPolygon pixel_square(long double x, long double y) {
  return {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}};
}

inline long double area(const LongPolygon& polygon) {
  long double twice = 0;
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    const LongPoint o = polygon[0], p = polygon[k], q = polygon[k + 1];
    twice += (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
  }
  return twice / 2;
}

// Of a square and a polygon that turns from x to y.
inline long double common_area(LongPolygon square, const LongPolygon& polygon) {
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const LongPoint p = polygon[k], q = polygon[(k + 1) % polygon.size()];
    square = clipped(square, [&](LongPoint r) { return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x); });
  }
  return area(square);
}

}  // namespace moire::test
