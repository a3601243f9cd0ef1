#include "metrics/point_set.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include <moire/random.h>

namespace moire::test {

using Catch::Approx;

namespace {

std::vector<Point> random_points(int count, int seed) {
  std::vector<Point> points;
  for (int k = 0; k < count; ++k) points.push_back({random({k, seed, 0, 7}, 0, 0), random({k, seed, 0, 7}, 0, 1)});
  return points;
}

}  // namespace

TEST_CASE("one point in the corner (1, 1) is in no box: the discrepancy is the mean square of the area") {
  const std::vector<Point> corner{{1, 1}};
  CHECK(star_discrepancy(corner) == Approx(1.0 / 3).epsilon(1e-12));  // of x y: 1/9
}

TEST_CASE("the discrepancy is the mean square over all boxes, as counting says") {
  // Over a grid of 400 x 400 boxes: the midpoint rule is off by the jumps at the points, at most one row and column of
  // cells for each, of an integrand at most 1.
  constexpr int grid = 400;
  for (int count : {1, 2, 5, 16}) {
    const auto points = random_points(count, count);
    double sum = 0;
    for (int i = 0; i < grid; ++i) {
      for (int j = 0; j < grid; ++j) {
        const double x = (i + 0.5) / grid, y = (j + 0.5) / grid;
        double share = 0;
        for (const Point& p : points) share += p.x < x && p.y < y;
        sum += std::pow(share / count - x * y, 2);
      }
    }
    const double expected = sum / (grid * grid), measured = star_discrepancy(points);
    CHECK(std::abs(measured * measured - expected) < 2.0 / grid);
  }
}

TEST_CASE("a regular grid is more even than points drawn at random") {
  std::vector<Point> grid;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) grid.push_back({(i + 0.5) / 4, (j + 0.5) / 4});
  }
  CHECK(star_discrepancy(grid) < star_discrepancy(random_points(16, 1)));
}

TEST_CASE("random points have power 1 at every frequency, a grid only where it repeats") {
  constexpr int sets = 400, reach = 6;
  std::vector<double> means(reach);
  for (int set = 0; set < sets; ++set) {
    const auto power = point_power(random_points(16, set), reach);
    for (int ring = 0; ring < reach; ++ring)
      means[static_cast<std::size_t>(ring)] += power[static_cast<std::size_t>(ring)].y / sets;
  }
  // A power is close to exponential, of deviation 1; a ring holds two or more, with their mirrors one each.
  for (double mean : means) CHECK(std::abs(mean - 1) < 4 / std::sqrt(2.0 * sets));

  std::vector<Point> grid;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) grid.push_back({(i + 0.5) / 4, (j + 0.5) / 4});
  }
  const auto power = point_power(grid, 4);
  CHECK(power.size() == 4);
  for (int ring = 0; ring < 3; ++ring) CHECK(power[static_cast<std::size_t>(ring)].y < 1e-20);
  CHECK(power[3].y > 1);  // (4, 0) and (0, 4)
}

}  // namespace moire::test
