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

}  // namespace moire::test
