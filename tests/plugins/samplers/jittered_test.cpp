// Jitter: every cell has its point, moved no farther than it says.
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "plugins/samplers/patterns.h"

namespace moire::test {

TEST_CASE("without jitter the points are those of a regular grid, bit for bit") {
  for (const std::int64_t n : {1, 2, 3, 7, 256}) {
    CAPTURE(n);
    const auto grid = pattern("supersample", {{"n", n}, {"layout", std::string("grid")}});
    const auto jittered = pattern("jittered", {{"n", n}, {"amount", 0.0}});
    CHECK(jittered->same_in_every_pixel());
    const auto points = points_of(*jittered, {3, 5, 2, 9});
    CHECK(same_places(points, points_of(*grid, {})));
    CHECK(std::all_of(points.begin(), points.end(), [](const auto& p) { return p.moved == Point{}; }));
    CHECK(jittered->spacing()->x == grid->spacing()->x);
    CHECK(jittered->spacing()->y == grid->spacing()->y);
  }
}

TEST_CASE("every cell of the grid has one point, within the amount of its middle") {
  for (const double amount : {0.25, 0.5, 1.0}) {
    for (const std::int64_t n : {1, 4, 5, 64}) {
      CAPTURE(amount, n);
      const auto jittered = pattern("jittered", {{"n", n}, {"amount", amount}});
      CHECK_FALSE(jittered->same_in_every_pixel());
      const double side = static_cast<double>(n);
      double farthest = 0;
      std::size_t wrong = 0;
      const auto points = points_of(*jittered, {12, 34, 0, 1});
      REQUIRE(points.size() == static_cast<std::size_t>(n * n));
      for (std::size_t k = 0; k < points.size(); ++k) {
        const auto& [x, y, weight, moved, light] = points[k];
        const double i = std::floor(static_cast<double>(k) / side), j = static_cast<double>(k) - side * i;
        const double across = x * side - (i + 0.5), down = y * side - (j + 0.5);
        // Products and quotients of numbers up to 64 are rounded by less than 1e-13.
        if (std::max(std::abs(across), std::abs(down)) > amount / 2 + 1e-13) ++wrong;
        if (std::abs(moved.x * side - across) > 1e-13 || std::abs(moved.y * side - down) > 1e-13) ++wrong;
        if (light || weight != 1 || x < 0 || x >= 1 || y < 0 || y >= 1) ++wrong;
        farthest = std::max({farthest, std::abs(across), std::abs(down)});
      }
      CHECK(wrong == 0);
      // Of 64 x 64 points, 8192 coordinates, the farthest is within 1 % of the whole way but once in 1e35.
      if (n == 64) CHECK(farthest > 0.99 * amount / 2);
    }
  }
}

}  // namespace moire::test
