// Points on outlines: each belongs to one side, by the rule that pixels have.
#include <catch2/catch_test_macros.hpp>

#include "plugins/primitives/brute_force.h"

namespace moire::test {
namespace {

using primitives::contains;
using primitives::shape_of;

// How many of the curves hold the point.
template <class Curve>
int holders(const std::vector<Curve>& curves, Point p) {
  int count = 0;
  for (const Curve& curve : curves) {
    const auto shape = shape_of(curve);
    count += shape && contains(*shape, p) ? 1 : 0;
  }
  return count;
}

LineCurve line(Point from, Point to, double width, Cap cap = Cap::butt) { return {1, {}, from, to, width, cap}; }

}  // namespace

TEST_CASE("a line that fills a pixel holds the points that the pixel holds, whichever way it runs") {
  for (const auto& curve : {line({3, 4.5}, {4, 4.5}, 1), line({4, 4.5}, {3, 4.5}, 1), line({3.5, 4}, {3.5, 5}, 1),
                            line({3.5, 5}, {3.5, 4}, 1), line({3.5, 4.5}, {3.5, 4.5}, 1, Cap::square)}) {
    const auto shape = *shape_of(curve);
    for (const double x : {2.75, 3.0, 3.5, 4.0, 4.25}) {
      for (const double y : {3.75, 4.0, 4.5, 5.0, 5.25}) {
        CAPTURE(x, y);
        CHECK(contains(shape, {x, y}) == (x >= 3 && x < 4 && y >= 4 && y < 5));
      }
    }
  }
}

TEST_CASE("lines side by side and end to end share no point and leave none out") {
  // Axes of length 10 in whole numbers, so that all corners are on a lattice.
  for (const auto& [ux, uy] : {std::pair{10.0, 0.0}, {0.0, 10.0}, {8.0, 6.0}, {-6.0, 8.0}, {-8.0, -6.0}}) {
    std::vector<LineCurve> tiles;
    for (int i = -2; i < 2; ++i) {
      for (int j = -2; j < 2; ++j) {
        const Point begin{i * ux - (j + 0.5) * uy, i * uy + (j + 0.5) * ux};
        const Point end{begin.x + ux, begin.y + uy};
        tiles.push_back((i + j) % 2 == 0 ? line(begin, end, 10) : line(end, begin, 10));
      }
    }
    // All points of a lattice that lie well inside; many are on edges and corners.
    for (int x = -10; x <= 10; ++x) {
      for (int y = -10; y <= 10; ++y) {
        CAPTURE(ux, uy, x, y);
        CHECK(holders(tiles, {double(x), double(y)}) == 1);
      }
    }
  }
}

TEST_CASE("a disk fills the hole of a ring of its radius") {
  // Of radius 25, with the 20 lattice points of 25 = 0, 15 + 20, 7 + 24 squared on the border.
  const std::vector<CircleCurve> curves{{1, {}, {0, 0}, 0, 50}, {2, {}, {0, 0}, 30, 10}, {3, {}, {0, 0}, 40, 10}};
  for (int x = -30; x <= 30; ++x) {
    for (int y = -30; y <= 30; ++y) {
      CAPTURE(x, y);
      CHECK(holders(curves, {double(x), double(y)}) == 1);
    }
  }
  CHECK(contains(*shape_of(curves[0]), {-25, 0}));
  CHECK_FALSE(contains(*shape_of(curves[0]), {25, 0}));
  CHECK(contains(*shape_of(curves[0]), {0, -25}));
  CHECK_FALSE(contains(*shape_of(curves[0]), {0, 25}));
}

}  // namespace moire::test
