// Where on the texture a ray meets the terrain: within the voxel that it sees, at the place where a cut of ray and box
// says, and moving with the image point as it does.
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "plugins/heightfield/brute_force.h"
#include "plugins/heightfield/views.h"

namespace moire::test {
namespace {

struct Place {
  double s, t;
  bool on_top;
};

// Where the ray first is within the box of a voxel that it sees.
Place place_on(const Map& map, const View& view, Ray ray, TexelIndex at) {
  const auto entry = [](double low, double high, double eye, double direction) {
    return direction == 0 ? 0 : std::min((low - eye) / direction, (high - eye) / direction);
  };
  const auto i = static_cast<double>(at.i), j = static_cast<double>(at.j);
  double t = std::max({0.0, entry(i * view.spacing_x, (i + 1) * view.spacing_x, view.x, ray.x),
                       entry(j * view.spacing_y, (j + 1) * view.spacing_y, view.y, ray.y)});
  const double top = map.height(at.i, at.j);
  const bool on_top = view.z + t * ray.z > top;
  if (on_top) t = (top - view.z) / ray.z;
  return {(view.x + t * ray.x) / view.spacing_x, (view.y + t * ray.y) / view.spacing_y, on_top};
}

SurfacePoint located(const Frame& frame, double x, double y) {
  const SamplePoint point{x, y};
  SurfacePoint result;
  Counters counters;
  frame.surface()->locate(std::span(&point, 1), std::span(&result, 1), counters);
  return result;
}

template <class Check>
void for_each_textured(const Map& map, const std::vector<View>& views, Check check) {
  const SmallTerrain terrain(map, views.front().spacing_x, views.front().spacing_y);
  for (const View& view : views) {
    const auto frame = terrain.frame(view);
    for (int y = 0; y < view.size.height; ++y) {
      for (int x = 0; x < view.size.width; ++x) {
        const SurfacePoint point = located(*frame, x + 0.5, y + 0.5);
        if (!point.textured) continue;
        CAPTURE(view.caption, view.yaw, view.pitch, x, y);
        check(view, *frame, point, x + 0.5, y + 0.5);
      }
    }
  }
}

}  // namespace

TEST_CASE("a hit lies within the voxel that is seen, walls included") {
  const Map map = usual_map();
  for_each_textured(map, all_views(map), [](const View&, const Frame&, const SurfacePoint& point, double, double) {
    const TexelIndex at = texel_index(point.hit.element);
    REQUIRE((point.level == 0 && at.level == 0));
    REQUIRE(static_cast<std::int64_t>(std::floor(point.s)) == at.i);
    REQUIRE(static_cast<std::int64_t>(std::floor(point.t)) == at.j);
  });
}

TEST_CASE("a hit lies where ray and box meet") {
  const Map map = usual_map();
  for_each_textured(map, views_all_round(),
                    [&](const View& view, const Frame&, const SurfacePoint& point, double x, double y) {
                      const Ray ray = ray_through(view, x, y);
                      const Place place = place_on(map, view, ray, texel_index(point.hit.element));
                      REQUIRE(std::abs(point.s - place.s) <= 1e-7);
                      REQUIRE(std::abs(point.t - place.t) <= 1e-7);
                    });
}

TEST_CASE("a hit on a top moves with the image point as its derivatives say") {
  constexpr double step = 1e-5;
  const Map map = usual_map();
  int compared = 0;
  for_each_textured(
      map, views_all_round(), [&](const View& view, const Frame& frame, const SurfacePoint& point, double x, double y) {
        if (std::abs(view.x) > 1e5) return;  // positions so far off have too few digits for differences over 2e-5
        bool all_on_this_top = true;
        const auto near_by = [&](double dx, double dy) {
          const SurfacePoint near = located(frame, x + dx, y + dy);
          all_on_this_top =
              all_on_this_top && near.hit.element == point.hit.element &&
              place_on(map, view, ray_through(view, x + dx, y + dy), texel_index(near.hit.element)).on_top;
          return near;
        };
        const SurfacePoint left = near_by(-step, 0), right = near_by(step, 0);
        const SurfacePoint above = near_by(0, -step), below = near_by(0, step);
        if (!all_on_this_top) return;
        ++compared;
        const auto agrees = [&](const SurfacePoint& before, const SurfacePoint& after, float ds, float dt) {
          const double tolerance = 1e-3 * (std::abs(ds) + std::abs(dt));
          return std::abs((after.s - before.s) / (2 * step) - ds) <= tolerance &&
                 std::abs((after.t - before.t) / (2 * step) - dt) <= tolerance;
        };
        REQUIRE(agrees(left, right, point.ds_dx, point.dt_dx));
        REQUIRE(agrees(above, below, point.ds_dy, point.dt_dy));
      });
  CHECK(compared > 3000);
}

// With its voxel a wall, a place stays on the wall, and moves along it.
TEST_CASE("a hit on a near wall moves with the image point as its derivatives say") {
  constexpr double step = 1e-5;
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  int compared = 0;
  for (const View& view : views_all_round()) {
    if (std::abs(view.x) > 1e5) continue;  // too few digits for differences over 2e-5
    const auto frame = terrain.frame(view, {{"face", std::string("near")}, {"coherence", std::string("none")}});
    for (int y = 0; y < view.size.height; ++y) {
      for (int x = 0; x < view.size.width; ++x) {
        const SurfacePoint point = located(*frame, x + 0.5, y + 0.5);
        if (!point.textured) continue;
        CAPTURE(view.caption, x, y);
        const bool across_s = std::abs(point.s - std::round(point.s)) < 1e-8;
        const bool across_t = std::abs(point.t - std::round(point.t)) < 1e-8;
        REQUIRE((across_s || across_t));
        if (across_s && across_t) continue;  // by an edge of the wall
        const auto moves = [&](double dx, double dy, float ds, float dt) {
          const SurfacePoint before = located(*frame, x + 0.5 - dx, y + 0.5 - dy);
          const SurfacePoint after = located(*frame, x + 0.5 + dx, y + 0.5 + dy);
          const auto stays = [&](const SurfacePoint& other) {
            const double moved = across_s ? other.s - point.s : other.t - point.t;
            return other.hit.element == point.hit.element && std::abs(moved) < 1e-8;
          };
          if (!stays(before) || !stays(after)) return;
          ++compared;
          const double tolerance = 1e-3 * (std::abs(ds) + std::abs(dt)) + 1e-7;
          REQUIRE((across_s ? ds : dt) == 0);
          REQUIRE(std::abs((after.s - before.s) / (2 * step) - ds) <= tolerance);
          REQUIRE(std::abs((after.t - before.t) / (2 * step) - dt) <= tolerance);
        };
        moves(step, 0, point.ds_dx, point.dt_dx);
        moves(0, step, point.ds_dy, point.dt_dy);
      }
    }
  }
  CHECK(compared > 3000);
}

}  // namespace moire::test
