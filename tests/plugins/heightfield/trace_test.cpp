// Rays of the scene `heightfield`, held to a brute force that shares no code with it: every ray is cut with every box.
// No pixel may be wrong. Rays that meet an edge within 1e-9 of a voxel may see either side of it; these are counted,
// and the count is bounded: 0 unless the view is tied to the grid.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include <fmt/format.h>

#include "plugins/heightfield/brute_force.h"
#include "plugins/heightfield/views.h"

namespace moire::test {
namespace {

const Changes independent_grid{{"coherence", std::string("none")}};
const Changes independent_major{{"coherence", std::string("none")}, {"walk", std::string("major")}};

struct Verdict {
  std::string first_wrong;  // what the brute force says of the first pixel that differs
  int wrong = 0, on_edges = 0;
};

std::string name_of(Element element) {
  if (element == background) return "sky";
  const TexelIndex at = texel_index(element);
  return fmt::format("voxel ({}, {}) of level {}", at.i, at.j, at.level);
}

Color color_of(Element element, const Map& map, Color sky) {
  if (element == background) return sky;
  const TexelIndex at = texel_index(element);
  return map.color(at.i, at.j);
}

// Traces these points in one batch, and judges each.
Verdict judge(const Map& map, const View& view, const Frame& frame, SeenBy* expected_at,
              const std::vector<SamplePoint>& points) {
  const Color sky = parse_color("#b8d4f0");
  std::vector<Hit> hits(points.size());
  Counters counters;
  frame.trace(points, hits, counters);
  Verdict verdict;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const std::vector<Element> expected = expected_at(map, view, ray_through(view, points[k].x, points[k].y));
    if (expected.size() > 1) ++verdict.on_edges;
    const bool is_right = std::find(expected.begin(), expected.end(), hits[k].element) != expected.end() &&
                          hits[k].color == color_of(hits[k].element, map, sky);
    if (is_right || verdict.wrong++ > 0) continue;
    verdict.first_wrong = fmt::format("at ({}, {}): {}, found {}", points[k].x, points[k].y, name_of(expected.front()),
                                      name_of(hits[k].element));
  }
  return verdict;
}

std::vector<SamplePoint> middles(ImageSize size) {
  std::vector<SamplePoint> points;
  for (int x = 0; x < size.width; ++x) {
    for (int y = size.height - 1; y >= 0; --y) points.push_back({x + 0.5, y + 0.5});
  }
  return points;
}

void check_views(const Map& map, const std::vector<View>& views, const Changes& changes, SeenBy* expected_at,
                 const Changes& made_with = {}) {
  const SmallTerrain terrain(map, views.front().spacing_x, views.front().spacing_y, made_with);
  for (const View& view : views) {
    CAPTURE(view.caption, view.yaw, view.pitch, view.x, view.y, view.z);
    const auto frame = terrain.frame(view, changes);
    const Verdict verdict = judge(map, view, *frame, expected_at, middles(view.size));
    CHECK(verdict.first_wrong == "");
    CHECK(verdict.wrong == 0);
    CHECK(verdict.on_edges <= view.on_edges);
  }
}

// The same views of a map whose voxels are larger, and not square.
std::vector<View> stretched(std::vector<View> views, double spacing_x, double spacing_y, double height) {
  for (View& view : views) {
    view.x *= spacing_x;
    view.y *= spacing_y;
    view.z *= height;
    view.far *= std::min(spacing_x, spacing_y);
    view.spacing_x = spacing_x;
    view.spacing_y = spacing_y;
  }
  return views;
}

Map raised(Map map, float factor) {
  for (float& height : map.heights) height *= factor;
  return map;
}

}  // namespace

TEST_CASE("every ray sees the box that a brute force finds nearest, whatever the view") {
  check_views(usual_map(), views_all_round(), independent_grid, seen_by);
}

TEST_CASE("every ray sees the nearest box from awkward places too") {
  check_views(usual_map(), awkward_views(usual_map()), independent_grid, seen_by);
}

TEST_CASE("every ray sees the nearest box of voxels that are not square") {
  const Map map = raised(usual_map(), 150);
  check_views(map, stretched(views_all_round(), 127.2, 166.8, 150), independent_grid, seen_by);
  check_views(map, stretched(awkward_views(usual_map()), 127.2, 166.8, 150), independent_grid, seen_by);
}

TEST_CASE("every ray sees the nearest box of maps of a single row, column or voxel") {
  for (const auto& [columns, rows] : {std::pair(1, 9), std::pair(9, 1), std::pair(1, 1), std::pair(3, 2)}) {
    CAPTURE(columns, rows);
    const Map map = rough_map(columns, rows, usual_relief, 5);
    check_views(map, views_all_round(), independent_grid, seen_by);
    check_views(map, awkward_views(map), independent_grid, seen_by);
  }
}

TEST_CASE("equal heights, seen from their own height and from above, hide nothing wrongly") {
  const Map map = flat_map(8, 8, 3);
  std::vector<View> views = views_all_round();
  for (View& view : views) {
    view.z = view.pitch == 0 ? 3 : 3 + view.z / 100;
    if (view.pitch == 0) view.on_edges = view.size.width * view.size.height;
  }
  check_views(map, views, independent_grid, seen_by);
}

TEST_CASE("a walk by major steps sees what a brute force of its definition sees") {
  check_views(usual_map(), views_all_round(), independent_major, seen_by_major_steps);
  check_views(usual_map(), awkward_views(usual_map()), independent_major, seen_by_major_steps);
  const Map map = raised(usual_map(), 150);
  check_views(map, stretched(views_all_round(), 127.2, 166.8, 150), independent_major, seen_by_major_steps);
}

TEST_CASE("rays along a grid line see the voxels to the south or east of it") {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  for (const double yaw : {0.0, 90.0}) {
    View view{.caption = "", .x = 4, .y = 7, .z = 11, .yaw = yaw, .pitch = -25, .size = {1, 64}};
    view.fov = 1;  // of a single column: the picture is 64 times as high
    const auto frame = terrain.frame(view, independent_grid);
    std::vector<SamplePoint> points;
    for (int y = 0; y < view.size.height; ++y) points.push_back({0.5, y + 0.5});
    View beside = view;
    (yaw == 0 ? beside.y : beside.x) += 1e-6;
    const Verdict verdict = judge(map, beside, *frame, seen_by, points);
    CHECK(verdict.first_wrong == "");
    CHECK(verdict.on_edges == 0);
  }
}

TEST_CASE("the unit of length does not matter: all lengths times a power of two give the same bits") {
  const SmallTerrain terrain(usual_map());
  const auto point = sampler("point"), area = sampler("area", {{"layout", std::string("radial")}});
  for (const float factor : {0x1p-29F, 0x1p20F, 0x1p29F}) {
    const SmallTerrain scaled(raised(usual_map(), factor), factor, factor);
    for (const View& view : all_views(usual_map())) {
      if (std::abs(view.x * factor) > 1e9 || std::abs(view.y * factor) > 1e9) continue;
      CAPTURE(view.caption, factor);
      const auto frame = terrain.frame(view), other = scaled.frame(stretched({view}, factor, factor, factor).front());
      CHECK(first_difference(rendered(*point, *frame), rendered(*point, *other)) == "");
      CHECK(first_difference(rendered(*area, *frame), rendered(*area, *other)) == "");
    }
  }
}

}  // namespace moire::test
