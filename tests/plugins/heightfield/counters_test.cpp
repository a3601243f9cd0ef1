// The paper's counts, on ground so simple that they can be worked out by hand: P pixels that hit, L voxels stepped
// over, M voxels seen, and M + P - 1 hits of area sampling.
//
// One column of 400 pixels, 1/572.957 of the distance wide each, 100 above flat ground of unit voxels. Looking 40
// degrees down, the column begins atan(200 / 572.957) = 19.242 degrees further down, where the ground is 100 /
// tan(59.242) = 59.512 away, and ends 100 / tan(20.758) = 263.839 away. Through the middles of the last pixels: 59.617
// and 263.221.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>

#include "plugins/heightfield/brute_force.h"
#include "plugins/heightfield/small_terrain.h"

namespace moire::test {
namespace {

constexpr int rows = 400;

View column_view(double yaw, double pitch) {
  return {.caption = "",
          .x = 0.25,
          .y = 0.5,
          .z = 100,
          .yaw = yaw,
          .pitch = pitch,
          .fov = 0.1,
          .far = 4000,
          .size = {1, rows}};
}

Rendered column(const View& view, const char* name, const Changes& changes = {}, const char* walk = "grid") {
  static const SmallTerrain terrain(flat_map(4, 4));
  return rendered(*sampler(name, changes), *terrain.frame(view, {{"walk", std::string(walk)}}));
}

}  // namespace

TEST_CASE("points on flat ground: one hit a pixel, and steps from the first voxel hit to the last") {
  const Counters counters = column(column_view(0, -40), "point").counters;
  CHECK(counters.queries == rows);
  CHECK(counters.hits == rows);
  CHECK(counters.steps == 263 - 59 + 1);  // voxels 59 (0.25 + 59.617) to 263 (0.25 + 263.221)
}

TEST_CASE("more points a pixel are more queries and hits over nearly the same steps") {
  const Counters counters = column(column_view(0, -40), "supersample", {{"n", std::int64_t{8}}}).counters;
  CHECK(counters.queries == 8 * rows);
  CHECK(counters.hits == 8 * rows);
  CHECK(counters.steps == 264 - 59 + 1);  // a sixteenth of a pixel from the column's ends, 263.76 + 0.25
}

TEST_CASE("area sampling on flat ground: M + P - 1 hits") {
  const Counters counters = column(column_view(0, -40), "area").counters;
  constexpr int voxels = 264 - 59 + 1;  // voxels 59 (0.25 + 59.512) to 264 (0.25 + 263.839)
  CHECK(counters.queries == rows);
  CHECK(counters.steps == voxels);
  CHECK(counters.hits == voxels + rows - 1);
}

TEST_CASE("steps of a track across both axes count the voxels under it; major steps count one a column") {
  const double yaw = std::numbers::pi / 6;
  const auto voxels = [&](double near, double far, double eye, double share) {
    return std::floor(eye + far * share) - std::floor(eye + near * share);
  };
  const double along = voxels(59.512, 263.839, 0.25, std::cos(yaw)),
               across = voxels(59.512, 263.839, 0.5, std::sin(yaw));
  const Counters grid = column(column_view(30, -40), "area").counters;
  CHECK(static_cast<double>(grid.steps) == along + across + 1);
  CHECK(static_cast<double>(grid.hits) == along + across + 1 + rows - 1);
  const Counters major = column(column_view(30, -40), "area", {}, "major").counters;
  CHECK(static_cast<double>(major.steps) == along + 1);
  CHECK(static_cast<double>(major.hits) == along + 1 + rows - 1);
}

TEST_CASE("pixels above the far limit are queries without hits, and end the count of steps") {
  View view = column_view(0, -15);
  view.far = 5000;
  // The ground ends atan(100 / 5000) = 1.146 degrees down, 572.957 tan(13.854) = 141.30 pixels above the middle, row
  // 58.693: the middles of rows 59 and below hit. The last of these is 4689 away (the one above: 5081).
  const Counters points = column(view, "point").counters;
  CHECK(points.queries == rows);
  CHECK(points.hits == rows - 59);
  const Rendered area = column(view, "area");
  CHECK(area.at(0, 57).fragments.size() == 1);
  CHECK(area.at(0, 57).fragments[0].element == background);
  double sky = 0;
  for (const Fragment& f : area.at(0, 58).fragments) sky += f.element == background ? f.weight : 0;
  CHECK(std::abs(sky - 0.693) < 0.0005);
}

TEST_CASE("without ground there is neither hit nor step") {
  for (const char* name : {"point", "supersample", "area"}) {
    const Counters counters = column(column_view(0, 60), name).counters;
    CHECK(counters.queries > 0);
    CHECK(counters.hits == 0);
    CHECK(counters.steps == 0);
  }
}

}  // namespace moire::test
