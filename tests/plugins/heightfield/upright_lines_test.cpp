// What upright image lines report, held to single rays: each pixel is seen in the vertical plane through its middle.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>

#include "plugins/heightfield/runs.h"
#include "plugins/heightfield/views.h"

namespace moire::test {
namespace {

// Upright stretches are seen in the vertical plane through their middle: a ray keeps its height and its advance along
// the axis along which the middle's ray advances more voxels, and is moved sideways into the plane.
class MiddlePlane {
 public:
  MiddlePlane(const View& view, double x, double low_y, double high_y)
      : view_(view), x_(x), middle_(ray_through(view, x, (low_y + high_y) / 2)) {
    steps_south_ = std::abs(middle_.y / view.spacing_y) > std::abs(middle_.x / view.spacing_x);
  }

  Ray ray(double y) const {
    const Ray ray = ray_through(view_, x_, y);
    if (steps_south_) return {ray.y * middle_.x / middle_.y, ray.y, ray.z};
    return {ray.x, ray.x * middle_.y / middle_.x, ray.z};
  }
  // Rise over advance in the plane.
  double slope(double y) const { return ray(y).z / advance(y); }
  double advance(double y) const {
    const Ray r = ray(y);
    return (r.x * middle_.x + r.y * middle_.y) / std::hypot(middle_.x, middle_.y);
  }
  // The camera's way forward over the ground; 0 at the height of the nadir and the zenith.
  double forward(double y) const {
    const Ray r = ray_through(view_, x_, y);
    const double yaw = view_.yaw * std::numbers::pi / 180;
    return r.x * std::cos(yaw) + r.y * std::sin(yaw);
  }

 private:
  const View& view_;
  double x_;
  Ray middle_;
  bool steps_south_;
};

}  // namespace

TEST_CASE("the runs of an upright column's pixels are what single rays in the plane of each pixel's middle see") {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  int runs = 0, two_ways = 0, stretches = 0;
  for (const View& view : all_views(map)) {
    const auto frame = terrain.frame(view, {{"coherence", std::string("none")}});
    const int height = view.size.height;
    std::vector<double> cuts;
    for (int i = 0; i <= height; ++i) cuts.push_back(i);
    for (const double x : {0.4, 7.3, view.size.width / 2.0, view.size.width - 0.27}) {
      Tally pieces(static_cast<std::size_t>(height), true);
      follow(*frame, {{x, static_cast<double>(height)}, {x, 0}, cuts}, pieces);
      for (int i = 0; i < height; ++i) {
        CAPTURE(view.caption, view.yaw, view.pitch, x, i);
        const auto slot = static_cast<std::size_t>(i);
        CHECK(std::abs(pieces.weight(slot) - 1) <= 1e-12);
        const MiddlePlane plane(view, x, height - i, height - i - 1);
        ++stretches;
        // Where a pixel looks both ways, it is seen as two stretches.
        if (plane.forward(height - i) * plane.forward(height - i - 1) <= 1e-12) {
          ++two_ways;
          continue;
        }
        const bool upward = plane.slope(height - i) < plane.slope(height - i - 1);
        Verdict verdict;
        judge(
            map, view, runs_of(pieces, slot, i, i + 1, upward), [&](double place) { return plane.ray(height - place); },
            verdict);
        CHECK(verdict.first_wrong == "");
        runs += verdict.runs;
      }
    }
  }
  CHECK(runs > 10'000);
  CHECK(two_ways < stretches / 50);
}

}  // namespace moire::test
