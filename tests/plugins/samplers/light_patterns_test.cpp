// Points of the light, through the sampler that hands them on.
#include <algorithm>
#include <cmath>
#include <set>

#include "support/plugins.h"

namespace moire::test {

namespace {

std::vector<LightPoint> lights_of(const char* pattern, int n, const Pixel& pixel) {
  const SamplerPlugin& plugin = sampler_plugin("light_samples");
  const auto sampler =
      plugin.make_points(changed(plugin.parameters, {{"pattern", std::string(pattern)}, {"n", std::int64_t{n}}}));
  Points points;
  sampler->points(pixel, points);
  std::vector<LightPoint> lights;
  for (const Points::Entry& entry : points.entries()) {
    CHECK(entry.x == 0.5);
    CHECK(entry.y == 0.5);
    CHECK(entry.weight == 1);
    lights.push_back(entry.light.value());
  }
  return lights;
}

bool same(const std::vector<LightPoint>& a, const std::vector<LightPoint>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](LightPoint p, LightPoint q) { return p.u == q.u && p.v == q.v; });
}

// The largest difference between the part of the points in a box at (0, 0) and its area, over boxes with a corner at a
// point, open or closed: the star discrepancy by its definition.
double discrepancy(const std::vector<LightPoint>& points) {
  const auto count = static_cast<double>(points.size());
  double largest = 0;
  std::vector<float> us{1}, vs{1};
  for (const LightPoint p : points) us.push_back(p.u), vs.push_back(p.v);
  for (const float u : us) {
    for (const float v : vs) {
      double open = 0, closed = 0;
      for (const LightPoint p : points) {
        open += p.u < u && p.v < v ? 1 : 0;
        closed += p.u <= u && p.v <= v ? 1 : 0;
      }
      const double area = static_cast<double>(u) * v;
      largest = std::max({largest, area - open / count, closed / count - area});
    }
  }
  return largest;
}

}  // namespace

TEST_CASE("points of a light lie in it, n x n of them, in every pattern") {
  for (const char* pattern : {"lattice", "grid", "jittered", "random", "rotated"}) {
    INFO(pattern);
    for (const int n : {1, 2, 3, 16}) {
      const auto lights = lights_of(pattern, n, {7, 9, 0, 3});
      REQUIRE(lights.size() == static_cast<std::size_t>(n * n));
      CHECK(std::all_of(lights.begin(), lights.end(),
                        [](LightPoint p) { return p.u >= 0 && p.u < 1 && p.v >= 0 && p.v < 1; }));
    }
  }
}

TEST_CASE("lattice and grid are the same in every pixel, the other patterns are not, and keep still in an animation") {
  for (const char* pattern : {"lattice", "grid", "jittered", "random", "rotated"}) {
    INFO(pattern);
    const bool is_same = pattern[0] == 'l' || pattern[0] == 'g';
    const auto here = lights_of(pattern, 4, {7, 9, 0, 3});
    CHECK(same(here, lights_of(pattern, 4, {8, 9, 0, 3})) == is_same);
    CHECK(same(here, lights_of(pattern, 4, {7, 9, 0, 4})) == is_same);
    CHECK(same(here, lights_of(pattern, 4, {7, 9, 5, 3})));
  }
}

TEST_CASE("each cell of a light's grid has its middle or one point of its own") {
  constexpr int n = 8;
  for (const char* pattern : {"grid", "jittered"}) {
    INFO(pattern);
    std::set<std::pair<int, int>> cells;
    for (const LightPoint p : lights_of(pattern, n, {1, 2, 0, 3})) {
      const int i = static_cast<int>(p.u * n), j = static_cast<int>(p.v * n);
      cells.insert({i, j});
      if (pattern[0] == 'g')
        CHECK((p.u * n - static_cast<float>(i) == 0.5F && p.v * n - static_cast<float>(j) == 0.5F));
    }
    CHECK(cells.size() == n * n);
  }
}

TEST_CASE("lattices fill a light more evenly than grids, and those than random points") {
  // Of 256 points. The box up to a grid's last point holds all of them and leaves (1 - 1 / (2 n))^2 of the light's
  // area: 1 / n - 1 / (4 n^2) too many. Lattices lie at about log N / N; random points at about the root of N.
  const auto at = [](const char* pattern) { return discrepancy(lights_of(pattern, 16, {1, 2, 0, 3})); };
  const double grid = at("grid");
  CHECK(std::abs(grid - (1.0 / 16 - 1.0 / 1024)) < 1e-6);
  CHECK(at("lattice") < grid / 2);
  CHECK(at("rotated") < grid / 2);
  CHECK(at("random") > at("lattice") * 2);
}

}  // namespace moire::test
