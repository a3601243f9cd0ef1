// Samplers that draw random numbers: keyed by seed, pixel and sample alone, uniform, and new in every frame on request.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <set>

#include "plugins/samplers/patterns.h"

namespace moire::test {

namespace {

constexpr const char* patterns[] = {"jittered", "random", "sobol"};

// The numbers in [0, 1) that a pattern's coordinates are made of. Of a jittered grid, where in its cell.
double number(std::string_view name, double coordinate) {
  const double cells = name == "jittered" ? 4 * coordinate : coordinate;
  return cells - std::floor(cells);
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;  // of uniform numbers about their mean, whose variance is 1/12
  for (std::size_t k = 0; k < a.size(); ++k) sum += 12 * (a[k] - 0.5) * (b[k] - 0.5);
  return sum / static_cast<double>(a.size());
}

}  // namespace

TEST_CASE("random points stay where they are from frame to frame, unless they are to be new in each") {
  for (const char* name : patterns) {
    CAPTURE(name);
    const auto still = pattern(name), reseeded = pattern(name, {{"reseed", std::string("frame")}});
    const auto first = points_of(*still, {3, 4, 0, 7});
    CHECK(same_places(first, points_of(*still, {3, 4, 99, 7})));
    CHECK(same_places(first, points_of(*reseeded, {3, 4, 0, 7})));
    CHECK_FALSE(same_places(first, points_of(*reseeded, {3, 4, 1, 7})));
    CHECK_FALSE(same_places(points_of(*reseeded, {3, 4, 1, 7}), points_of(*reseeded, {3, 4, 2, 7})));
  }
}

TEST_CASE("an animation of random points is the same picture over and over where nothing moves, unless reseeded") {
  const auto scene = scene_plugin("cartoon").make(Settings(scene_plugin("cartoon").parameters));
  const auto frame = scene->frame(Settings(scene_plugin("cartoon").parameters), {24, 20});
  for (const char* name : {"jittered", "random", "sobol", "adaptive"}) {
    for (const char* reseed : {"never", "frame"}) {
      CAPTURE(name, reseed);
      Changes changes{{"reseed", std::string(reseed)}};
      if (name == std::string("adaptive")) changes.emplace_back("method", std::string("two_level"));
      const auto made = sampler(name, changes);
      const auto at = [&](int number) {
        return rendered(*made->begin({.frame = *frame, .seed = 5, .frame_number = number}), *frame);
      };
      CHECK((first_difference(at(0), at(1)) == "") == (reseed == std::string("never")));
    }
  }
}

TEST_CASE("no two pixels and no two seeds have the same random points") {
  for (const char* name : patterns) {
    CAPTURE(name);
    const auto made = pattern(name);
    std::set<std::pair<double, double>> firsts;
    for (int x = 0; x < 32; ++x) {
      for (int y = 0; y < 32; ++y) {
        for (const std::uint64_t seed : {0U, 1U}) {
          const auto points = points_of(*made, {x, y, 0, seed});
          firsts.emplace(points.front().x, points.front().y);
        }
      }
    }
    CHECK(firsts.size() == 2 * 32 * 32);
  }
}

TEST_CASE("one more sample leaves the others where they are") {
  for (const char* name : {"random", "sobol"}) {
    const auto few = points_of(*pattern(name, {{"points", std::int64_t{5}}}), {1, 2, 0, 3});
    auto more = points_of(*pattern(name, {{"points", std::int64_t{6}}}), {1, 2, 0, 3});
    REQUIRE(more.size() == 6);
    more.pop_back();
    CHECK(same_places(few, more));
  }
}

TEST_CASE("every sample is uniform, and independent of its other coordinate, of other pixels and of other seeds") {
  constexpr int side = 128;
  constexpr double count = side * side;
  for (const char* name : patterns) {
    const auto made = pattern(name);
    for (const std::size_t sample : {std::size_t{0}, std::size_t{1}, std::size_t{15}}) {
      CAPTURE(name, sample);
      std::vector<double> x, y, right, below, other_seed;
      std::vector<int> cells(64);
      for (int column = 0; column < side; ++column) {
        for (int row = 0; row < side; ++row) {
          const auto one = points_of(*made, {column, row, 0, 1})[sample];
          x.push_back(number(name, one.x));
          y.push_back(number(name, one.y));
          right.push_back(number(name, points_of(*made, {column + 1, row, 0, 1})[sample].x));
          below.push_back(number(name, points_of(*made, {column, row + 1, 0, 1})[sample].x));
          other_seed.push_back(number(name, points_of(*made, {column, row, 0, 2})[sample].x));
          ++cells[static_cast<std::size_t>(8 * x.back()) * 8 + static_cast<std::size_t>(8 * y.back())];
        }
      }
      // Chi squared of 63 degrees of freedom: mean 63, standard deviation sqrt(126). Beyond 5 of these once in 1e5.
      double chi_squared = 0;
      for (const int cell : cells) chi_squared += std::pow(cell - count / 64, 2) / (count / 64);
      CHECK(std::abs(chi_squared - 63) < 5 * std::sqrt(126));
      // Correlations of independent numbers have the standard deviation 1 / sqrt(count).
      for (const auto* other : {&y, &right, &below, &other_seed})
        CHECK(std::abs(correlation(x, *other)) < 4.5 / std::sqrt(count));
    }
  }
}

}  // namespace moire::test
