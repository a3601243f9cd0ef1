// What hard pixels are drawn with: chance, and polygons about the pixel [0, 1) x [0, 1).
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "support/polygon_frame.h"

namespace moire::test::hard {

using Contour = std::vector<Point>;

// The standard library's engine is the same everywhere, its distributions are not.
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : engine_(seed) {}

  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double between(double a, double b) { return a + unit() * (b - a); }
  int whole(int first, int last) { return first + static_cast<int>(unit() * (last - first + 1)); }
  bool one_in(int n) { return whole(1, n) == 1; }
  // Of magnitudes as of signs, each is as likely as any other.
  double tiny(double smallest, double largest) {
    return (one_in(2) ? 1 : -1) * std::exp(between(std::log(smallest), std::log(largest)));
  }
  Point point(double low, double high) { return {between(low, high), between(low, high)}; }

 private:
  std::mt19937_64 engine_;
};

// A drawing in the making.
struct Sketch {
  Chance chance;
  std::vector<FlatPolygon> polygons;

  // Behind all others, of any fill rule.
  void add(std::vector<Contour> contours) {
    const FillRule rule = chance.one_in(2) ? FillRule::nonzero : FillRule::even_odd;
    polygons.push_back({0, {}, rule, std::move(contours)});
  }
  Contour any_contour(int corners, double low = -0.5, double high = 1.5) {
    Contour contour;
    for (int i = 0; i < corners; ++i) contour.push_back(chance.point(low, high));
    return contour;
  }
  // One that covers the pixel, in every other drawing.
  void add_ground() {
    if (chance.one_in(2)) add({{{-1, -1}, {2, -1.5}, {2.5, 2}, {-1.25, 2.25}}});
  }
};

inline Point at(Point p, Point q, double t) { return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)}; }

// Regular, about a middle, from an angle in radians; every `step`th corner comes next.
inline Contour star(Point middle, double radius, int corners, int step, double angle) {
  Contour contour;
  for (int i = 0; i < corners; ++i) {
    const double a = angle + 2 * std::numbers::pi * step * i / corners;
    contour.push_back({middle.x + radius * std::cos(a), middle.y + radius * std::sin(a)});
  }
  return contour;
}

inline Contour box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

}  // namespace moire::test::hard
