// Polygons of lines and circles: their areas on paper, how far they are from their curves, which come and in what
// order.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>

#include "plugins/primitives/brute_force.h"
#include "primitives/seeing/outlines.h"
#include "support/pieces.h"

namespace moire::test {
namespace {

using primitives::shape_of;
constexpr double pi = std::numbers::pi;
constexpr Rectangle everything{-1e9, -1e9, 1e9, 1e9};

template <class Curve>
std::vector<Outline> contours_of(const Curve& curve, const Rectangle& window, double tolerance) {
  primitives::Outline outline;
  outline_of(*shape_of(curve), window, tolerance, outline);
  std::vector<Outline> contours;
  for (std::size_t k = 0; k < outline.contours.size(); ++k) {
    const auto begin = outline.points.begin() + outline.contours[k];
    const auto end =
        k + 1 < outline.contours.size() ? outline.points.begin() + outline.contours[k + 1] : outline.points.end();
    contours.emplace_back(begin, end);
  }
  return contours;
}

// How far corners and points of the edges are from the curve's outline, at the most.
template <class Curve>
double largest_distance(const Curve& curve, const std::vector<Outline>& contours) {
  long double largest = 0;
  for (const Outline& contour : contours) {
    for (std::size_t k = 0; k < contour.size(); ++k) {
      const Point a = contour[k], b = contour[(k + 1) % contour.size()];
      for (int i = 0; i < 8; ++i) {
        const Point p{a.x + i / 8.0 * (b.x - a.x), a.y + i / 8.0 * (b.y - a.y)};
        largest = std::max(largest, std::abs(depth(curve, p)));
      }
    }
  }
  return static_cast<double>(largest);
}

}  // namespace

TEST_CASE("a line without round ends is its rectangle") {
  const auto butt = contours_of(LineCurve{1, {}, {10, 20}, {50, 50}, 5, Cap::butt}, everything, 0.01);
  REQUIRE(butt.size() == 1);
  CHECK(butt[0] == Outline{{8.5, 22}, {11.5, 18}, {51.5, 48}, {48.5, 52}});
  CHECK(area_of(butt[0]) == 250);
  const auto square = contours_of(LineCurve{1, {}, {10, 20}, {50, 50}, 5, Cap::square}, everything, 0.01);
  CHECK(square[0] == Outline{{6.5, 20.5}, {9.5, 16.5}, {53.5, 49.5}, {50.5, 53.5}});
  const auto point = contours_of(LineCurve{1, {}, {10, 20}, {10, 20}, 5, Cap::square}, everything, 0.01);
  CHECK(point[0] == Outline{{7.5, 22.5}, {7.5, 17.5}, {12.5, 17.5}, {12.5, 22.5}});
}

TEST_CASE("polygons of circles and round ends have the area of their curves and are within the tolerance of them") {
  for (const double tolerance : {1e-4, 0.01, 0.3, 10.0}) {
    for (const double radius : {0.3, 2.0, 35.0, 900.0}) {
      CAPTURE(tolerance, radius);
      const CircleCurve disk{1, {}, {7, -3}, radius / 2, radius};
      const auto corners = contours_of(disk, everything, tolerance);
      REQUIRE(corners.size() == 1);
      CHECK(std::abs(std::abs(area_of(corners[0])) / (pi * radius * radius) - 1) < 1e-12);
      // A disk's depth counts from its border.
      const CircleCurve border{1, {}, {7, -3}, radius, 0};
      CHECK(largest_distance(border, corners) <= tolerance);

      const CircleCurve ring{1, {}, {7, -3}, radius, radius / 4};
      const auto both = contours_of(ring, everything, tolerance);
      REQUIRE(both.size() == 2);
      const double area = std::abs(area_of(both[0])) - std::abs(area_of(both[1]));
      CHECK(std::abs(area / (2 * pi * radius * radius / 4) - 1) < 1e-11);
      CHECK(largest_distance(ring, both) <= tolerance);

      const LineCurve capsule{1, {}, {7, -3}, {7 + 3 * radius, -3 + 4 * radius}, 2 * radius, Cap::round};
      const auto whole = contours_of(capsule, everything, tolerance);
      REQUIRE(whole.size() == 1);
      CHECK(std::abs(std::abs(area_of(whole[0])) / (radius * radius * (10 + pi)) - 1) < 1e-12);
      CHECK(largest_distance(capsule, whole) <= tolerance);

      const LineCurve dot{1, {}, {7, -3}, {7, -3}, 2 * radius, Cap::round};
      const auto round = contours_of(dot, everything, tolerance);
      CHECK(std::abs(std::abs(area_of(round[0])) / (radius * radius * pi) - 1) < 1e-12);
    }
  }
}

TEST_CASE("of a huge circle only what passes the window is made of short chords") {
  const Rectangle window{0, 0, 100, 80};
  for (const double radius : {1e4, 1e7, 1e12}) {
    CAPTURE(radius);
    const CircleCurve ring{1, {}, {50 + 0.6 * radius, 40 + 0.8 * radius}, radius, 30};
    const auto contours = contours_of(ring, window, 1e-4);
    REQUIRE(contours.size() == 2);
    // Chords are 2 sqrt(2 * 1e-4 * radius) long or more; the window's diagonal is 128, and up to 40 chords, ever
    // longer, lead up to it.
    for (const Outline& contour : contours)
      CHECK(static_cast<double>(contour.size()) < 200 / std::sqrt(8e-4 * radius) + 160);
    // Coordinates of `radius` are exact to 1e-16 of it; so is the square root of their squares.
    const double rounding = 1e-15 * radius;
    for (const Outline& contour : contours) {
      for (std::size_t k = 0; k < contour.size(); ++k) {
        const Point a = contour[k], b = contour[(k + 1) % contour.size()];
        for (int i = 0; i < 16; ++i) {
          const Point p{a.x + i / 16.0 * (b.x - a.x), a.y + i / 16.0 * (b.y - a.y)};
          if (p.x < 0 || p.y < 0 || p.x > 100 || p.y > 80) continue;
          CHECK(std::abs(depth(ring, p)) <= 1e-4 + rounding);
        }
      }
    }
    // The long chords leave nothing of the window out and add nothing to it.
    for (const Point p : {Point{1, 1}, {99, 1}, {50, 40}, {1, 79}, {99, 79}, {62, 52}, {38, 28}}) {
      const bool inside = holds(contours[0], p) != holds(contours[1], p);
      CHECK(inside == (depth(ring, p) > 0));
    }
  }
}

TEST_CASE("polygons come front to back, those that touch the window and have an area") {
  const std::vector<primitives::Curve> curves{LineCurve{1, {}, {10, 20}, {50, 20}, 4, Cap::butt},
                                              CircleCurve{2, {}, {30, 20}, 5, 2},
                                              LineCurve{3, {}, {10, 20}, {50, 20}, 0, Cap::round},
                                              LineCurve{4, {}, {10, 20}, {10, 20}, 4, Cap::butt},
                                              CircleCurve{5, {}, {70, 50}, 5, 2},
                                              CircleCurve{6, {}, {30, 20}, 8, 0},
                                              LineCurve{7, {}, {10, 30}, {10, 30}, 2, Cap::square},
                                              CircleCurve{8, {}, {40, 25}, 0, 10}};
  const auto frame = frame_of(curves, {80, 60});
  const auto elements = [&](const Rectangle& window) {
    std::vector<Element> result;
    for (const Piece& piece : pieces_of(*frame->polygons(), window).all) result.push_back(piece.element);
    return result;
  };
  CHECK(elements({0, 0, 80, 60}) == std::vector<Element>{8, 7, 5, 2, 1});
  CHECK(elements({60, 40, 80, 60}) == std::vector<Element>{5});
  CHECK(elements({0, 29, 20, 35}) == std::vector<Element>{7});
  CHECK(elements({52, 0, 60, 40}).empty());
  CHECK_FALSE(frame->polygons()->disjoint());
  CHECK(frame->polygons()->background_color() == Color{1, 1, 1});
}

}  // namespace moire::test
