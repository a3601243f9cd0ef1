#include "sampling/strands.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "framework/sampling/pattern.h"
#include "message_of.h"

namespace moire::test {

namespace {

using Doubles = std::vector<double>;

Doubles heights(const Strand& strand) {
  Doubles result;
  for (const SamplePoint& point : strand.points) result.push_back(point.y);
  return result;
}

Doubles places(const Strand& strand) {
  Doubles result;
  for (const SamplePoint& point : strand.points) result.push_back(point.x);
  return result;
}

// The message about these points, in a column of one pixel.
std::string complaint(const std::vector<Points::Entry>& points) {
  return message_of([&] { Strands(Pattern(points), {3, 0}, 7, 1); });
}

}  // namespace

TEST_CASE("points that share x are one strand, from the bottom of the image to its top") {
  const Strands strands(Pattern({{0.25, 0.25, 1}, {0.75, 0.5, 1}, {0.25, 0.75, 1}}), {5, 0}, 10, 2);
  REQUIRE(strands.all().size() == 2);
  const Strand &left = strands.all()[0], &right = strands.all()[1];
  CHECK(places(left) == Doubles(4, 5.25));
  CHECK(heights(left) == Doubles{11.75, 11.25, 10.75, 10.25});
  CHECK(left.rows == std::vector<std::uint32_t>{1, 1, 0, 0});
  CHECK(places(right) == Doubles(2, 5.75));
  CHECK(heights(right) == Doubles{11.5, 10.5});
}

TEST_CASE("points of many x lie in upright strips, as many as the root of their number") {
  const Strands strands(Pattern({{0.375, 0.125, 1}, {0.875, 0.375, 1}, {0.125, 0.625, 1}, {0.5, 0.875, 1}}), {0, 0}, 0,
                        1);
  REQUIRE(strands.all().size() == 2);
  CHECK(places(strands.all()[0]) == Doubles{0.125, 0.375});
  CHECK(heights(strands.all()[0]) == Doubles{0.625, 0.125});
  CHECK(places(strands.all()[1]) == Doubles{0.5, 0.875});  // a strip begins with its left end
  CHECK(heights(strands.all()[1]) == Doubles{0.875, 0.375});
}

TEST_CASE("the weights of a pixel sum to 1 over all strands") {
  const Strands strands(Pattern({{0.25, 0.5, 1}, {0.75, 0.5, 3}, {0.75, 0.25, 4}}), {0, 0}, 0, 1);
  REQUIRE(strands.all().size() == 2);
  CHECK(strands.all()[0].weights == Doubles{0.125});
  CHECK(strands.all()[1].weights == Doubles{0.375, 0.5});
}

TEST_CASE("a pattern that is the same in every pixel is asked for once and moves to other columns") {
  const Pattern pattern({{0.25, 0.5, 1}, {0.75, 0.5, 1}});
  Strands strands(pattern, {0, 0}, 0, 20);
  CHECK(pattern.asked == 1);
  strands.move_to(9);
  CHECK(places(strands.all()[0]) == Doubles(20, 9.25));
  CHECK(places(strands.all()[1]) == Doubles(20, 9.75));
}

TEST_CASE("a pattern that changes is asked for in each pixel") {
  std::vector<int> asked;
  const Changing changing([&](const Pixel& pixel, Points& out) {
    asked.push_back(pixel.y);
    for (int k = 0; k < pixel.y; ++k) out.add(0.5, (k + 0.5) / pixel.y);
  });
  const Strands strands(changing, {2, 0, 0, 5}, 1, 3);
  CHECK(asked == std::vector{3, 2, 1});
  REQUIRE(strands.all().size() == 1);
  CHECK(strands.all()[0].rows == std::vector<std::uint32_t>{2, 2, 2, 1, 1, 0});
  CHECK(strands.all()[0].weights == Doubles{1.0 / 3, 1.0 / 3, 1.0 / 3, 0.5, 0.5, 1});
}

TEST_CASE("a sampler that gives no points, or points that are none, is told so") {
  const double nan = std::nan(""), infinity = HUGE_VAL;
  CHECK(complaint({}) == "pixel (3, 7): the sampler gave no points; at least one is needed");
  const std::string rest = "; points lie in [0, 1) x [0, 1) and have finite weights";
  CHECK(complaint({{0.5, 0.5, 1}, {1, 0.5, 1}}) == "pixel (3, 7): the sampler gave point (1, 0.5) of weight 1" + rest);
  CHECK(complaint({{0, 0, 1}, {0.5, -0.25, 1}}) ==
        "pixel (3, 7): the sampler gave point (0.5, -0.25) of weight 1" + rest);
  CHECK(complaint({{nan, 0.5, 1}}) == "pixel (3, 7): the sampler gave point (nan, 0.5) of weight 1" + rest);
  CHECK(complaint({{0.5, nan, 1}}) == "pixel (3, 7): the sampler gave point (0.5, nan) of weight 1" + rest);
  CHECK(complaint({{0.5, 0.5, infinity}}) == "pixel (3, 7): the sampler gave point (0.5, 0.5) of weight inf" + rest);
}

TEST_CASE("weights that sum to nothing are refused, since they are divided by their sum") {
  CHECK(complaint({{0.25, 0.5, 1}, {0.75, 0.5, -1}}) ==
        "pixel (3, 7): the sampler gave points whose weights sum to 0; the sum is a finite number other than 0");
  CHECK(complaint({{0.25, 0.5, 1e308}, {0.75, 0.5, 1e308}}) ==
        "pixel (3, 7): the sampler gave points whose weights sum to inf; the sum is a finite number other than 0");
}

TEST_CASE("a point of the light goes with its point, and the host gives one to those that have none") {
  Points::Entry lit{0.25, 0.5, 1}, other{0.25, 0.75, 1};
  lit.light = {0.125F, 0.625F};
  const Strands strands(Pattern({lit, other}), {4, 0}, 0, 1, 7);
  REQUIRE(strands.all().size() == 1);
  const auto& points = strands.all()[0].points;
  CHECK((points[1].u == 0.125F && points[1].v == 0.625F));
  CHECK((points[0].u != 0.5F && points[0].v != 0.5F));
  const Strands dark(Pattern({lit, other}), {4, 0}, 0, 1);
  CHECK((dark.all()[0].points[1].u == 0.5F && dark.all()[0].points[1].v == 0.5F));
}

TEST_CASE(
    "the host's points of the light are spread over it in each pixel, and differ from pixel to pixel and by seed") {
  constexpr std::uint32_t count = 64;
  const auto counts_in = [](const Pixel& pixel, std::uint64_t seed) {
    // Of the 16 cells of a 4 x 4 grid: 4 points each if they were perfectly even.
    std::vector<int> cells(16);
    const LightLattice lattice(pixel, seed, count);
    for (std::uint32_t k = 0; k < count; ++k) {
      const LightPoint p = lattice.point(k);
      REQUIRE((p.u >= 0 && p.u < 1 && p.v >= 0 && p.v < 1));
      ++cells[static_cast<std::size_t>(p.u * 4) * 4 + static_cast<std::size_t>(p.v * 4)];
    }
    return cells;
  };
  for (int x = 0; x < 50; ++x) {
    // Independent points leave a cell empty with probability .24 a pixel, and some cell with 9 or more of .27.
    for (const int cell : counts_in({x, 3}, 1)) CHECK((cell >= 1 && cell <= 8));
  }
  const auto first = [](const Pixel& pixel, std::uint64_t seed) { return LightLattice(pixel, seed, count).point(0).u; };
  CHECK(first({5, 3}, 1) != first({6, 3}, 1));
  CHECK(first({5, 3}, 1) != first({5, 3}, 2));
  CHECK(first({5, 3, 0}, 1) == first({5, 3, 9}, 1));
}

TEST_CASE("over pixels a point's place on the light is uniform whichever of a pixel's points it is") {
  // The mean of u of 4,000 independent uniform numbers is .5 +- .0046; six times that is 1 in 10^9.
  constexpr int pixels = 4000;
  for (const std::uint32_t k : {0U, 3U, 15U}) {
    double u = 0, v = 0;
    for (int x = 0; x < pixels; ++x) {
      const LightPoint p = LightLattice({x, 11}, 5, 16).point(k);
      u += p.u, v += p.v;
    }
    CHECK(std::abs(u / pixels - 0.5) < 6 * 0.0046);
    CHECK(std::abs(v / pixels - 0.5) < 6 * 0.0046);
  }
}

TEST_CASE("points outside the light are refused") {
  Points::Entry lit{0.25, 0.5, 1};
  lit.light = {1, 0.5F};
  CHECK(complaint({lit}) ==
        "pixel (3, 7): the sampler gave point (1, 0.5) of the light; such points lie in [0, 1) x [0, 1)");
}

}  // namespace moire::test
