// Positions along a column of 20,000 steps. A walk that adds its slope step by step drifts, the more the coarser its
// numbers; one that computes each position from the eye does not. What drift would cost is computed here for the
// variants one might choose, over the same slopes; the scene's own positions are held to exact ones.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <cstdint>
#include <vector>

#include "plugins/heightfield/brute_force.h"
#include "plugins/heightfield/small_terrain.h"

namespace moire::test {
namespace {

constexpr int steps = 20'000;

// Advances in y for a step in x, all over the octant.
std::vector<double> slopes() {
  std::vector<double> result;
  for (int k = 0; k < 40; ++k) result.push_back(std::tan((k + 0.37) * 1.1 * 3.14159265358979323846 / 180));
  return result;
}

constexpr double begin = 511.6;

// How far y(n) is from begin + n slope after `n` steps, at worst over all slopes.
template <class Walk>
double drift(int n, Walk y) {
  double worst = 0;
  for (const double slope : slopes()) {
    const long double exact = static_cast<long double>(begin) + static_cast<long double>(n) * slope;
    worst = std::max(worst, static_cast<double>(std::abs(static_cast<long double>(y(slope, n)) - exact)));
  }
  return worst;
}

template <class Number>
double added_up(double slope, int n) {
  Number y = static_cast<Number>(begin);
  for (int k = 0; k < n; ++k) y += static_cast<Number>(slope);
  return static_cast<double>(y);
}

double fixed_point(double slope, int n) {
  const auto fixed = [](double v) { return static_cast<std::int64_t>(std::lround(v * 65536)); };
  return static_cast<double>(fixed(begin) + n * fixed(slope)) / 65536;
}

double recomputed_in_float(double slope, int n) {
  return static_cast<double>(static_cast<float>(begin) + static_cast<float>(n) * static_cast<float>(slope));
}

// A ray's height, added up in float over n steps and set to the exact one every `base` steps, against the exact one at
// the worst of these steps.
double height_drift(int base) {
  double worst = 0;
  for (const double fall : {-0.0493, -0.0517, -0.0871}) {
    float height = 1000;
    for (int n = 1; n <= steps; ++n) {
      height += static_cast<float>(fall);
      const double exact = 1000 + n * fall;
      worst = std::max(worst, std::abs(static_cast<double>(height) - exact));
      if (n % base == 0) height = static_cast<float>(exact);
    }
  }
  return worst;
}

}  // namespace

// Single precision, added up: after n steps y is about n, and each step rounds it by up to n 2^-24, all one way where
// the slope stays on one side of a multiple of the last place; n^2 2^-25 in all, 12 voxels, and some thousandths after
// 400 steps.
TEST_CASE("positions added up in single precision miss the voxel after 20,000 steps, and hardly do after 400") {
  CHECK(drift(400, added_up<float>) < 0.02);
  CHECK(drift(400, added_up<float>) > 0.001);
  CHECK(drift(steps, added_up<float>) > 1);
  CHECK(drift(steps, added_up<float>) < 12);
}

// The slope is rounded once, to 2^-17 at worst: 0.15 of a voxel.
TEST_CASE("positions in 16.16 fixed point are off by a tenth of a voxel after 20,000 steps") {
  CHECK(drift(steps, fixed_point) > 0.05);
  CHECK(drift(steps, fixed_point) < (steps + 1) * 0x1p-17);
}

// The slope is rounded by 2^-25 at most, which 20,000 steps make 6e-4, and the result by 2^-10.
TEST_CASE("positions recomputed in single precision are off by thousandths of a voxel") {
  CHECK(drift(steps, recomputed_in_float) > 1e-4);
  CHECK(drift(steps, recomputed_in_float) < 3e-3);
}

// n^2 2^-54 at worst.
TEST_CASE("positions added up in double precision are off by less than 1e-7 of a voxel") {
  CHECK(drift(steps, added_up<double>) < steps * (steps * 0x1p-54));
}

// Heights of up to 1000 round by 2^-15 a step.
TEST_CASE("heights of rays added up in single precision drift unless they are based anew") {
  CHECK(height_drift(steps) > 0.02);
  CHECK(height_drift(50) < 50 * 0x1p-14);
  CHECK(height_drift(steps) > 20 * height_drift(50));
}

// A place 2^k voxels off has steps of 2^(k - 23) in single precision.
TEST_CASE("far from the origin single precision cannot tell places within a voxel apart") {
  const auto worst = [](double origin) {
    double off = 0;
    for (int k = 0; k < 1000; ++k) {
      const double place = origin + k / 1000.0;
      off = std::max(off, std::abs(place - static_cast<double>(static_cast<float>(place))));
    }
    return off;
  };
  CHECK(worst(131'072) > 0.007);
  CHECK(worst(131'072) <= 0x1p-7);
  CHECK(worst(2'097'152) > 0.12);
  CHECK(worst(2'097'152) <= 0x1p-3);
}

// A place is known by its distance x along the track and x times the slope across it: two roundings of numbers below
// 2^15, besides those of the test's own ray, and the place is kept 1e-9 within its voxel.
TEST_CASE("places at the end of a column of 20,000 steps lie on their ray, with no drift") {
  const SmallTerrain terrain(flat_map(16, 12));
  for (const double yaw : {3.0, 20.0, 41.0, 75.0, 200.0}) {
    const View view{.caption = "",
                    .x = 3.3,
                    .y = 5.7,
                    .z = 100,
                    .yaw = yaw,
                    .pitch = -5,
                    .fov = 0.5,
                    .far = 30'000,
                    .size = {1, 21}};
    const auto frame = terrain.frame(view);
    std::vector<SamplePoint> points;
    for (int k = 210; k >= 0; --k) points.push_back({0.5, k / 10.0});
    std::vector<SurfacePoint> places(points.size());
    Counters counters;
    frame->surface()->locate(points, places, counters);
    double farthest = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (!places[k].textured) continue;
      CAPTURE(yaw, k);
      const Ray ray = ray_through(view, points[k].x, points[k].y);
      const double x = places[k].s - view.x, y = places[k].t - view.y;
      CHECK(std::abs(x * ray.y - y * ray.x) / std::hypot(ray.x, ray.y) <= 2e-9);
      farthest = std::max(farthest, std::max(std::abs(x), std::abs(y)));
    }
    CHECK(farthest > steps);
  }
}

}  // namespace moire::test
