// Polygons as a scene streams them, and what one can say of them by cutting them with straight lines.
#pragma once

#include <cmath>
#include <vector>

#include <moire/frame.h>

namespace moire::test {

using Outline = std::vector<Point>;

struct Piece {
  Element element;
  Color color;
  Outline outline;
};

// Keeps all polygons, of one contour each.
class Pieces final : public PolygonSink {
 public:
  void polygon(const Polygon& p) override {
    all.push_back({p.element, p.color, Outline(p.points.begin(), p.points.end())});
  }
  std::vector<Piece> all;
};

inline Pieces pieces_of(const Polygons& polygons, const Rectangle& window) {
  Pieces pieces;
  polygons.stream(window, pieces);
  return pieces;
}

// Signed; positive where the outline turns from the x axis to the y axis.
inline double area_of(const Outline& outline) {
  double doubled = 0;
  for (std::size_t k = 1; k + 1 < outline.size(); ++k) {
    const Point &a = outline[0], &b = outline[k], &c = outline[k + 1];
    doubled += (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  }
  return doubled / 2;
}

// The part of an outline where value(point), linear, is not negative: Sutherland and Hodgman 1974. Of an outline that
// is not convex parts may hang together by edges of no area.
template <class Value>
Outline part_of(const Outline& outline, Value value) {
  Outline part;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Point &a = outline[k], &b = outline[(k + 1) % outline.size()];
    const double va = value(a), vb = value(b);
    if (va >= 0) part.push_back(a);
    if ((va < 0) != (vb < 0)) part.push_back({a.x + va / (va - vb) * (b.x - a.x), a.y + va / (va - vb) * (b.y - a.y)});
  }
  return part;
}

inline Outline part_in_pixel(const Outline& outline, int x, int y) {
  Outline part = part_of(outline, [&](Point p) { return p.x - x; });
  part = part_of(part, [&](Point p) { return x + 1 - p.x; });
  part = part_of(part, [&](Point p) { return p.y - y; });
  return part_of(part, [&](Point p) { return y + 1 - p.y; });
}

// By the number of edges on a ray from the point.
inline bool holds(const Outline& outline, Point p) {
  bool inside = false;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Point &a = outline[k], &b = outline[(k + 1) % outline.size()];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

}  // namespace moire::test
