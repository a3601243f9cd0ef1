// Lines and circles that formulae get wrong: without length, radius or width, enormous, on one another.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <map>
#include <numbers>

#include "plugins/primitives/brute_force.h"
#include "support/plugins.h"

namespace moire::test {
namespace {

using Curves = std::vector<primitives::Curve>;
constexpr double pi = std::numbers::pi;
constexpr ImageSize size{24, 16};

// The area of each element in the image, in pixels, by exact polygons.
std::map<Element, double> areas(const Curves& curves, double tolerance = 1e-4) {
  const auto frame = frame_of(curves, size, tolerance);
  std::map<Element, double> sums;
  for (const Content& pixel : rendered(*sampler("area", {{"method", std::string("exact")}}), *frame).pixels) {
    for (const Fragment& f : pixel.fragments) sums[f.element] += f.weight;
  }
  return sums;
}

// The same by 64 exact lines a pixel.
std::map<Element, double> areas_by_lines(const Curves& curves) {
  const auto frame = frame_of(curves, size);
  std::map<Element, double> sums;
  const auto lines = sampler("area", {{"method", std::string("line")}, {"lines", std::int64_t{64}}});
  for (const Content& pixel : rendered(*lines, *frame).pixels) {
    for (const Fragment& f : pixel.fragments) sums[f.element] += f.weight;
  }
  return sums;
}

// By points on a lattice off all outlines.
std::map<Element, int> points(const Curves& curves) {
  std::vector<Point> places;
  for (int x = 0; x < 4 * size.width; ++x) {
    for (int y = 0; y < 4 * size.height; ++y) places.push_back({0.25 * x + 0.11, 0.25 * y + 0.07});
  }
  std::map<Element, int> counts;
  for (const Element element : elements_at(*frame_of(curves, size), places)) ++counts[element];
  return counts;
}

class Count final : public CurveSink {
 public:
  void line(const LineCurve& c) override { elements.push_back(c.element); }
  void circle(const CircleCurve& c) override { elements.push_back(c.element); }
  std::vector<Element> elements;
};

LineCurve line(Element element, Point from, Point to, double width, Cap cap = Cap::butt) {
  return {element, {}, from, to, width, cap};
}
CircleCurve circle(Element element, Point center, double radius, double width) {
  return {element, {}, center, radius, width};
}

}  // namespace

TEST_CASE("what covers no area is seen by no point, line or polygon, and is a curve all the same") {
  const Curves curves{line(1, {3, 3}, {3, 3}, 4),
                      line(2, {3, 3}, {9, 5}, 0),
                      line(3, {3, 3}, {9, 5}, 0, Cap::round),
                      line(4, {3, 3}, {3, 3}, 0, Cap::square),
                      circle(5, {8, 8}, 3, 0),
                      circle(6, {8, 8}, 0, 0)};
  CHECK(points(curves) == std::map<Element, int>{{0, 16 * size.width * size.height}});
  CHECK(areas(curves) == std::map<Element, double>{{0, size.width * size.height}});
  CHECK(areas_by_lines(curves) == std::map<Element, double>{{0, size.width * size.height}});
  Count count;
  frame_of(curves, size)->curves()->stream(count);
  CHECK(count.elements == std::vector<Element>{1, 2, 3, 4, 5, 6});
}

TEST_CASE("an empty picture is its background") {
  CHECK(areas({}) == std::map<Element, double>{{0, size.width * size.height}});
  CHECK(areas_by_lines({}) == std::map<Element, double>{{0, size.width * size.height}});
  CHECK(points({}) == std::map<Element, int>{{0, 16 * size.width * size.height}});
}

TEST_CASE("a line without length and a circle without radius are squares and disks of their width") {
  CHECK(std::abs(areas({line(1, {8, 8}, {8, 8}, 5, Cap::square)})[1] - 25) < 1e-12);
  CHECK(std::abs(areas({line(1, {8, 8}, {8, 8}, 5, Cap::round)})[1] - pi * 6.25) < 1e-12);
  CHECK(std::abs(areas({circle(1, {8, 8}, 0, 5)})[1] - pi * 6.25) < 1e-12);
  // A ring so wide that its hole is closed, exactly and by far.
  CHECK(std::abs(areas({circle(1, {8, 8}, 2.5, 5)})[1] - pi * 25) < 1e-12);
  CHECK(std::abs(areas({circle(1, {8, 8}, 1, 8)})[1] - pi * 25) < 1e-12);
  // A hole of nearly nothing.
  CHECK(std::abs(areas({circle(1, {8, 8}, 2.5 + 1e-9, 5)})[1] - pi * 25) < 1e-6);
}

TEST_CASE("a line has the same area at every angle, reversed as well") {
  for (const double angle : {0.0, 1e-12, 1e-6, 0.1, pi / 4, pi / 4 + 1e-9, 1.0, pi / 2, pi / 2 + 1e-14, 2.5, pi, 4.0}) {
    CAPTURE(angle);
    const Point from{12 - 5 * std::cos(angle), 8 - 5 * std::sin(angle)};
    const Point to{12 + 5 * std::cos(angle), 8 + 5 * std::sin(angle)};
    for (const double width : {1e-3, 1.0, 3.0}) {
      CHECK(std::abs(areas({line(1, from, to, width)})[1] - 10 * width) < 1e-12);
      CHECK(std::abs(areas({line(1, to, from, width)})[1] - 10 * width) < 1e-12);
    }
    CHECK(points({line(1, from, to, 3)}) == points({line(1, to, from, 3)}));
  }
}

TEST_CASE("lines that cross share the area once, the one in front has it") {
  const Curves cross{line(1, {2, 8}, {22, 8}, 2), line(2, {12, 1}, {12, 15}, 3)};
  CHECK(areas(cross) == std::map<Element, double>{{0, 24 * 16 - 40 - 42 + 6}, {1, 34}, {2, 42}});
  auto seen = areas_by_lines(cross);
  CHECK(std::abs(seen[1] - 34) < 1e-11);
  CHECK(std::abs(seen[2] - 42) < 1e-11);
  // Of equal ones only the last is seen, not a sliver of the other.
  const Curves twice{line(1, {2.1, 3.7}, {19.3, 12.9}, 1.7, Cap::round),
                     line(2, {2.1, 3.7}, {19.3, 12.9}, 1.7, Cap::round)};
  CHECK_FALSE(areas(twice).contains(1));
  CHECK_FALSE(areas_by_lines(twice).contains(1));
  CHECK_FALSE(points(twice).contains(1));
}

TEST_CASE("enormous lines, rings and disks cover what they cover, and nothing overflows") {
  const double huge = 1e7;
  CHECK(areas({circle(1, {0, 0}, huge, huge)})[0] == 24 * 16);      // the image is in the hole
  CHECK(areas({circle(1, {0, 0}, huge / 3, huge)})[1] == 24 * 16);  // and in the disk
  CHECK(areas({line(1, {-huge, -huge}, {huge, huge}, huge)})[1] == 24 * 16);
  CHECK(areas({line(1, {-huge, 8}, {huge, 8}, 2, Cap::round)})[1] == 48);
  // The right border of a ring of radius 1e7 in the middle of the image: its width, times the image's height.
  const Curves ring{circle(1, {12 - huge, 8}, huge, 3)};
  CHECK(std::abs(areas(ring)[1] - 48) < 1e-6);
  CHECK(std::abs(areas_by_lines(ring)[1] - 48) < 16 / 64.0);
  // Of 1e13, as zooming may make them.
  const double zoomed = 1e13;
  CHECK(areas({circle(1, {0, 0}, zoomed, zoomed)})[0] == 24 * 16);
  CHECK(areas({circle(1, {0, 0}, zoomed / 3, zoomed)})[1] == 24 * 16);
  CHECK(areas({line(1, {-zoomed, -zoomed}, {zoomed, zoomed}, zoomed, Cap::round)})[1] == 24 * 16);
  CHECK(points({circle(1, {0, 0}, zoomed, zoomed)}).contains(0));
  CHECK(points({circle(1, {0, 0}, zoomed / 3, zoomed)}).contains(1));
  // As short as numbers can be.
  CHECK(std::abs(areas({line(1, {0, 0}, {5e-324, 0}, 4, Cap::square)})[1] - 4) < 1e-12);
  CHECK(areas({line(1, {8, 8}, {9, 8}, 5e-324, Cap::round)})[0] == 24 * 16);
}

TEST_CASE("polygons and lines agree on what many curves cover") {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Curves curves = random_curves(12, size, seed);
    const auto exact = areas(curves, 1e-4);
    auto by_lines = areas_by_lines(curves);
    for (const auto& [element, area] : exact) {
      CAPTURE(seed, element);
      // By a rule of 64 points a pixel in x, of a function that jumps at upright ends: each end, of which an element
      // has few visible ones, may cost a strip of half a line's width, 1/128 pixel, as long as the end.
      CHECK(std::abs(area - by_lines[element]) < 4 * size.height / 128.0);
    }
  }
}

}  // namespace moire::test
