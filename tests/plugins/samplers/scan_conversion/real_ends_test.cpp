// Two-point lines between real points, against their definition in long double.
#include "lines/real_ends.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "picture.h"
#include "sanitized.h"

namespace moire::test {
namespace {

using namespace scan_conversion;

constexpr PixelArea area{-50, -50, 100, 100};

using Real = long double;

// Weight of a pixel: what the line covers of its column, times the tent of its distance down the column.
Real weight(Point from, Point to, int x, int y) {
  const bool steep = std::abs(to.y - from.y) > std::abs(to.x - from.x);
  const Real u0 = steep ? from.y : from.x, u1 = steep ? to.y : to.x, v0 = steep ? from.x : from.y;
  const Real rise = steep ? Real{to.x} - from.x : Real{to.y} - from.y;
  const Real u = steep ? y : x, v = (steep ? x : y) + Real{0.5};
  const Real covered = std::min(std::max(u0, u1), u + 1) - std::max(std::min(u0, u1), u);
  if (covered <= 0) return 0;
  const Real f = v0 + (u + Real{0.5} - u0) * rise / (u1 - u0);
  return covered * std::max(Real{0}, 1 - std::abs(v - f));
}

}  // namespace

TEST_CASE("lines with real ends are within two levels of their definition, and their sum is their length") {
  Numbers numbers(1);
  for (const LineMethod method : {LineMethod::accumulator, LineMethod::direct, LineMethod::fujimoto_iwata}) {
    for (int k = 0; k < (sanitized ? 60 : 500); ++k) {
      const double reach = k % 5 == 0 ? 1 : 48;
      const auto place = [&] { return numbers.real(-reach, reach); };
      const Point from{place(), place()}, to{place(), place()};
      Picture picture(area);
      two_point_line({.method = method}, from, to, area, picture);
      // floor(256 f) against 255 f: up to a level of one and its inverse; an end column's sum and share are rounded.
      double worst = 0;
      picture.for_each_pixel([&](int x, int y) {
        worst = std::max(worst, std::abs(static_cast<double>(picture.at(x, y) - 255 * weight(from, to, x, y))));
      });
      const double length = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
      CAPTURE(from.x, from.y, to.x, to.y, int(method));
      CHECK(worst <= 2);
      CHECK(picture.again == 0);
      CHECK(std::abs(static_cast<double>(picture.sum) - 255 * length) <= 1 + 1e-9);
    }
  }
}

TEST_CASE("all methods draw the same line with real ends but for a level where the accumulator's error shows") {
  Numbers numbers(2);
  int different = 0, lines = 0;
  for (int k = 0; k < 300; ++k, ++lines) {
    const auto place = [&] { return numbers.real(-48, 48); };
    const Point from{place(), place()}, to{place(), place()};
    Picture pictures[3] = {Picture(area), Picture(area), Picture(area)};
    for (const LineMethod method : {LineMethod::accumulator, LineMethod::direct, LineMethod::fujimoto_iwata}) {
      two_point_line({.method = method}, from, to, area, pictures[static_cast<int>(method)]);
    }
    different += pictures[0].differences(pictures[1]) + pictures[1].differences(pictures[2]) > 0 ? 1 : 0;
  }
  // 50 columns of an error below 50 / 2^32, one of 256 levels each: one line in 10^5.
  CHECK(different == 0);
}

TEST_CASE("real ends in the middles of pixels differ from rounded ones by half of the columns at the ends") {
  Numbers numbers(3);
  for (int k = 0; k < 300; ++k) {
    const auto number = [&] { return numbers.integer(-40, 40); };
    const PixelIndex from{number(), number()}, to{number(), number()};
    const Octant octant = octant_of(from, to);
    if (octant.columns < 2) continue;
    Picture rounded(area), real(area);
    two_point_line({.both_ends = false}, from, to, area, rounded);
    const auto middle = [](PixelIndex p) {
      return Point{static_cast<double>(p.x) + 0.5, static_cast<double>(p.y) + 0.5};
    };
    two_point_line({.both_ends = false}, middle(from), middle(to), area, real);
    int differences = 0;
    rounded.for_each_pixel([&](int x, int y) {
      const bool steep = octant.column.x == 0;
      const std::int64_t u = steep ? y : x;
      if (u == (steep ? from.y : from.x) || u == (steep ? to.y : to.x)) return;
      differences += rounded.at(x, y) != real.at(x, y) ? 1 : 0;
    });
    CHECK(differences == 0);
    CHECK(real.at(from.x, from.y) == 128);
    CHECK(real.at(to.x, to.y) == 128);
  }
}

TEST_CASE("a line at 45 degrees beside the middles of pixels has two pixels a column all along") {
  for (const LineMethod method : {LineMethod::accumulator, LineMethod::direct, LineMethod::fujimoto_iwata}) {
    Picture picture(area);
    two_point_line({.method = method}, Point{0, 0.25}, Point{20, 20.25}, area, picture);
    for (int i = 0; i < 20; ++i) {
      CHECK(picture.at(i, i) == 191);
      CHECK(picture.at(i, i + 1) == 64);
    }
  }
}

TEST_CASE("a moving line with real ends keeps its sum to a level, one with rounded ends changes by columns") {
  std::uint64_t least = ~0U, most = 0;
  for (int frame = 0; frame < 128; ++frame) {
    const double x = frame / 16.0, y = 0.37 * x;
    Picture picture(area);
    two_point_line({}, Point{1.3 + x, 2.1 + y}, Point{20.4 + x, 9.7 + y}, area, picture);
    least = std::min(least, picture.sum);
    most = std::max(most, picture.sum);
  }
  CHECK(most - least <= 2);
}

}  // namespace moire::test
