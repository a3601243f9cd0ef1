// Hard cases of the scene `heightfield`, each with its outcome. Where the others stand:
//
//   positions and heights added up step by step, in float,   drift_test: what it would cost, and that ours do not drift
//   fixed point or double; single precision far off
//   1e7 voxels from the origin                               here
//   eye on a grid line, on a vertex, yaw 0, 45, 90 ...       trace_test, lines_test (awkward_views)
//   the same moved by 1e-9; the side rule of grid lines      here; trace_test "rays along a grid line"
//   pitch 0, upward, steep, fields of view of 10 to 100      trace_test, lines_test, upright_lines_test (all_views)
//   fields of view of .01 and 170 degrees; 1 and 120         trace_test (awkward_views); here
//   eye at the height of the ground                          trace_test "equal heights"
//   eye just above, on, in the ground                        trace_test, lines_test (awkward_views); here
//   pitch -90, nadir in the picture                          trace_test (awkward_views), lines_test "the other way"
//   far limit: a horizontal distance, the same for both      trace_test, lines_test (awkward_views), resume_test "flat
//   major axes; within a voxel, of a few, long               ground", counters_test
//   far limit of 0, and as good as none                      here
//   flat tops edge-on, voxels of no area                     here
//   maps of one row, column or voxel                         trace_test
//   heights that are no finite numbers                       here
//   the exact picture: all_views and a far limit within      visible_voxels_test; within and on the ground, edge-on,
//   a voxel                                                  far off, far limit 0 here
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "message_of.h"
#include "plugins/heightfield/brute_force.h"
#include "plugins/heightfield/views.h"

namespace moire::test {
namespace {

// All ways of area sampling.
const std::vector<Changes> area_ways{
    {{"layout", std::string("upright")}}, {{"layout", std::string("radial")}}, {{"method", std::string("exact")}}};

const Changes independent{{"coherence", std::string("none")}};

std::vector<std::unique_ptr<Sampler>> samplers() {
  std::vector<std::unique_ptr<Sampler>> all;
  all.push_back(sampler("point"));
  for (const Changes& way : area_ways) all.push_back(sampler("area", way));
  return all;
}

std::map<Element, double> merged(const Content& pixel) {
  std::map<Element, double> weights;
  for (const Fragment& f : pixel.fragments) weights[f.element] += f.weight;
  return weights;
}

// The weight that `a` gives to other elements than `b`, or more of.
double excess(const std::map<Element, double>& a, const std::map<Element, double>& b) {
  double sum = 0;
  for (const auto& [element, weight] : a) {
    const auto same = b.find(element);
    sum += std::max(0.0, weight - (same == b.end() ? 0 : same->second));
  }
  return sum;
}

std::set<Element> all_seen(const Rendered& image) {
  std::set<Element> elements;
  for (const Content& pixel : image.pixels) {
    for (const Fragment& f : pixel.fragments) elements.insert(f.element);
  }
  return elements;
}

}  // namespace

// Only the middle column looks along the grid line. On the line it sees the voxels to the south, as if moved there.
TEST_CASE("an eye moved off a vertex by 1e-9 changes what the column along the grid line sees, and nothing else") {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  const auto area = sampler("area");
  View view{.caption = "", .x = 4, .y = 7, .z = 11, .yaw = 0, .pitch = -5, .far = 40.5, .size = {25, 40}};
  const Rendered on_vertex = rendered(*area, *terrain.frame(view, independent));
  for (const auto& [dx, dy] : {std::pair(1e-9, 0.0), std::pair(-1e-9, 0.0), std::pair(0.0, 1e-9), std::pair(0.0, -1e-9),
                               std::pair(-1e-9, -1e-9)}) {
    CAPTURE(dx, dy);
    View moved = view;
    moved.x += dx;
    moved.y += dy;
    const Rendered image = rendered(*area, *terrain.frame(moved, independent));
    for (int x = 0; x < view.size.width; ++x) {
      for (int y = 0; y < view.size.height; ++y) {
        CAPTURE(x, y);
        const auto before = merged(on_vertex.at(x, y)), after = merged(image.at(x, y));
        if (x != 12 || dy >= 0) CHECK(excess(before, after) <= 1e-6);
        if (x != 12) continue;
        for (const auto& [element, weight] : after) {
          CHECK((element == background || texel_index(element).j == (dy < 0 ? 6 : 7)));
        }
      }
    }
  }
}

TEST_CASE("fields of view of 1 and of 120 degrees") {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  for (const double fov : {1.0, 120.0}) {
    for (const double yaw : {0.0, 45.0, 90.0, 200.0}) {
      for (const double pitch : {-90.0, -60.0, -20.0, 0.0, 15.0}) {
        const View view{.caption = "", .x = 3.3, .y = 5.7, .z = 9, .yaw = yaw, .pitch = pitch, .fov = fov};
        CAPTURE(fov, yaw, pitch);
        const Rendered image = rendered(*sampler("point"), *terrain.frame(view, independent));
        const Rendered radial = rendered(*sampler("area", {{"layout", std::string("radial")}}), *terrain.frame(view));
        int wrong = 0;
        for (int x = 0; x < view.size.width; ++x) {
          for (int y = 0; y < view.size.height; ++y) {
            const auto expected = seen_by(map, view, ray_through(view, x + 0.5, y + 0.5));
            const Element found = image.at(x, y).fragments[0].element;
            wrong += std::find(expected.begin(), expected.end(), found) == expected.end() ? 1 : 0;
          }
        }
        CHECK(wrong == 0);
        CHECK(std::all_of(radial.pixels.begin(), radial.pixels.end(),
                          [](const Content& pixel) { return std::abs(pixel.weight - 1) <= 1e-12; }));
      }
    }
  }
}

TEST_CASE("an eye within a voxel sees that voxel and nothing else") {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  for (const double depth : {1e-6, 0.5, 100.0}) {
    for (const double pitch : {-90.0, -30.0, 0.0, 60.0, 90.0}) {
      View view{.caption = "", .x = 5.3, .y = 2.8, .yaw = 77, .pitch = pitch, .fov = 90};
      view.z = map.height(5, 2) - depth;
      for (const Changes& way : area_ways) {
        CAPTURE(depth, pitch, way);
        const auto area = sampler("area", way);
        CHECK(all_seen(rendered(*area, *terrain.frame(view))) == std::set{texel_element(0, 5, 2)});
      }
      CHECK(all_seen(rendered(*sampler("point"), *terrain.frame(view))) == std::set{texel_element(0, 5, 2)});
    }
  }
}

TEST_CASE("an eye on the ground sees the voxel below it below the horizon, and what is higher above") {
  Map map = flat_map(8, 8, 3);
  map.heights[map.place(6, 3)] = 5;
  const SmallTerrain terrain(map);
  const View view{.caption = "", .x = 2.5, .y = 3.5, .z = 3, .yaw = 0, .pitch = 0, .fov = 60, .far = 6, .size = {9, 8}};
  for (const auto& by : samplers()) {
    const Rendered image = rendered(*by, *terrain.frame(view));
    for (int x = 0; x < 9; ++x) {
      for (int y = 4; y < 8; ++y) {
        const auto seen = merged(image.at(x, y));
        CHECK((seen.size() == 1 && seen.begin()->first == texel_element(0, 2, 3)));
        CHECK(std::abs(seen.begin()->second - 1) <= 1e-12);
      }
    }
    CHECK(image.at(4, 3).fragments[0].element == texel_element(0, 6, 3));
    CHECK(image.at(0, 3).fragments[0].element == background);
  }
}

// The horizon lies on the border of two rows of pixels: the plateau's first voxels end there, and its tops, seen from
// their own height, take up nothing.
TEST_CASE("flat tops seen edge-on are not seen, and have no fragments of no area") {
  Map map = flat_map(16, 4, 3);
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 6; ++i) map.heights[map.place(i, j)] = 0;
  }
  const SmallTerrain terrain(map);
  const View view{.caption = "", .x = 2.4, .y = 1.7, .z = 3, .fov = 40, .far = 12, .size = {10, 12}};
  for (const char* walk : {"grid", "major"}) {
    const auto frame = terrain.frame(view, {{"walk", std::string(walk)}});
    for (Changes way : area_ways) {
      if (!frame->polygons() && way[0].first == "method") continue;
      way.push_back({"lines", std::int64_t{3}});
      CAPTURE(walk, way);
      const Rendered image = rendered(*sampler("area", way), *frame);
      for (int x = 0; x < 10; ++x) {
        for (int y = 0; y < 12; ++y) {
          CAPTURE(x, y);
          for (const Fragment& f : image.at(x, y).fragments) {
            CHECK(f.weight > 0);
            CHECK((f.element == background) == (y < 6));
            if (y >= 6) CHECK(texel_index(f.element).i <= 6);
          }
        }
      }
    }
  }
}

TEST_CASE("1e7 voxels from the origin everything looks as beside it, to the bit") {
  const Map map = usual_map();  // mirrored after 32 columns and 24 rows
  const SmallTerrain terrain(map);
  constexpr std::int64_t east = 32 * 312'500, south = 24 * 416'667;
  for (const double yaw : {0.0, 20.0, 135.5, 250.0}) {
    for (const double pitch : {-70.0, -20.0, 0.0}) {
      CAPTURE(yaw, pitch);
      const View view{.caption = "", .x = 3.25, .y = 5.75, .z = 9, .yaw = yaw, .pitch = pitch};
      View distant = view;
      distant.x += east;
      distant.y -= south;
      for (const auto& by : samplers()) {
        const Rendered image = rendered(*by, *terrain.frame(view));
        Rendered same = rendered(*by, *terrain.frame(distant));
        for (Content& pixel : same.pixels) {
          for (Fragment& f : pixel.fragments) {
            if (f.element == background) continue;
            const TexelIndex at = texel_index(f.element);
            f.element = texel_element(0, at.i - east, at.j + south);
          }
        }
        CHECK(first_difference(image, same) == "");
      }
    }
  }
}

TEST_CASE("with a far limit of 0 all is sky, even from within the ground") {
  const SmallTerrain terrain(usual_map());
  for (const double z : {-1.0, 9.0}) {
    const View view{.caption = "", .x = 3.3, .y = 5.7, .z = z, .pitch = -60, .far = 0};
    for (const auto& by : samplers()) {
      CHECK(all_seen(rendered(*by, *terrain.frame(view))) == std::set{background});
    }
  }
}

// A pixel is 1/500 of the distance high here. At the largest far limit the ground ends 10 / 1e9 below the horizon, 5e-6
// of a pixel.
TEST_CASE("at the largest far limit rays go on to the ground or the sky, and the ground goes on to the horizon") {
  const SmallTerrain terrain(flat_map(64, 64, 0));
  View view{.caption = "", .x = 3.3, .y = 5.7, .z = 10, .yaw = 20, .far = 1e9, .size = {1, 9}};
  view.fov = 2 * std::atan(0.5 / 500) * 180 / 3.14159265358979323846;
  const Rendered points = rendered(*sampler("point"), *terrain.frame(view, independent));
  for (int y = 0; y < 9; ++y) {
    CAPTURE(y);
    const Element seen = points.at(0, y).fragments[0].element;
    REQUIRE((seen == background) == (y < 5));
    if (seen == background) continue;
    const double distance = 10 * 500 / (y - 4.0);
    const TexelIndex at = texel_index(seen);
    const double east = static_cast<double>(at.i) - view.x, south = static_cast<double>(at.j) - view.y;
    CHECK(std::abs(std::hypot(east, south) - distance) < 2);
  }
  const Rendered area = rendered(*sampler("area"), *terrain.frame(view, {{"levels", std::string("floor")}}));
  for (int y = 0; y < 9; ++y) {
    CAPTURE(y);
    const auto weights = merged(area.at(0, y));
    const auto sky = weights.find(background);
    CHECK(std::abs((sky == weights.end() ? 0 : sky->second) - std::clamp(4.5 - y, 0.0, 1.0)) <= 6e-6);
  }
}

TEST_CASE("heights that are not finite are refused by their place, in the image or once they are scaled") {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), infinity, -infinity}) {
    Map map = flat_map(4, 3, 1);
    map.heights[map.place(2, 1)] = bad;
    const std::string message = message_of([&] { SmallTerrain{map}; });
    CHECK(message.ends_with("height.exr: height at column 2, row 1 is not a finite number; every pixel needs one"));
  }
  Map map = flat_map(4, 3, 1);
  map.heights[map.place(2, 1)] = 1e30F;
  CHECK(message_of([&] {
          SmallTerrain(map, 1, 1, {{"height_scale", 1e9}});
        }) == "heightfield: the height of column 2, row 1 is beyond 3.4e38 once scaled; give a smaller height_scale");
}

}  // namespace moire::test
