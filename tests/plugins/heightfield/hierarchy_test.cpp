// The hierarchy: mean voxels twice as wide a level, each shown from the distance where a pixel's footprint is so wide.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>
#include <set>

#include "plugins/heightfield/brute_force.h"
#include "plugins/heightfield/views.h"

namespace moire::test {
namespace {

// Heights and colours in steps of 1/64 below 16, so that means of 4 x 4 are exact.
Map even_map() {
  Map map = usual_map();
  const auto round = [](float v) { return std::floor(v * 64) / 64; };
  for (float& height : map.heights) height = round(height);
  for (Color& color : map.colors) color = {round(color.r), round(color.g), round(color.b)};
  return map;
}

// Every voxel the mean of `width` x `width`.
Map means_of(const Map& map, int width) {
  Map coarse{map.columns / width, map.rows / width, {}, {}};
  const float share = 1 / static_cast<float>(width * width);
  for (int j = 0; j < coarse.rows; ++j) {
    for (int i = 0; i < coarse.columns; ++i) {
      float height = 0;
      Color color;
      for (int k = 0; k < width * width; ++k) {
        height += share * map.height(i * width + k % width, j * width + k / width);
        color = color + share * map.color(i * width + k % width, j * width + k / width);
      }
      coarse.heights.push_back(height);
      coarse.colors.push_back(color);
    }
  }
  return coarse;
}

Changes with_levels(double level_constant, const char* rule = "floor") {
  return {{"levels", std::string(rule)}, {"level_constant", level_constant}, {"coherence", std::string("none")}};
}

// Distances over the ground where levels 1, 2 ... begin, after the rule: voxels of 2^l where level_constant times the
// footprint of a pixel, at the slant distance to ground of mean height, is 2^l wide; rounded, 2^(l - 1/2).
std::vector<double> begins(const Map& map, const View& view, double level_constant, std::string_view rule) {
  const double half = rule == "round" ? 0.5 : 0;
  double mean = 0;
  for (const float height : map.heights) mean += height / static_cast<double>(map.heights.size());
  const double pixel_angle = 2 * std::tan(view.fov * std::numbers::pi / 360) / view.size.width;
  std::vector<double> result{0};
  for (int l = 1; l <= 2; ++l) {
    const double slant = std::exp2(l - half) / (level_constant * pixel_angle), drop = view.z - mean;
    result.push_back(slant > std::abs(drop) ? std::sqrt(slant * slant - drop * drop) : 0);
  }
  result.push_back(HUGE_VAL);
  return result;
}

void check_mean_voxels(const char* face, SeenBy* seen_by_ray) {
  const Map map = even_map(), coarse = means_of(map, 4);
  const SmallTerrain terrain(map);
  Changes changes = with_levels(1000);  // from the eye on, the coarsest: 4 x 4 voxels
  changes.push_back({"face", std::string(face)});
  for (View view : views_all_round()) {
    CAPTURE(view.caption, face);
    const auto frame = terrain.frame(view, changes);
    View wide = view;
    wide.spacing_x = wide.spacing_y = 4;
    int wrong = 0;
    for (int y = 0; y < view.size.height; ++y) {
      for (int x = 0; x < view.size.width; ++x) {
        const SamplePoint point{x + 0.5, y + 0.5};
        Hit hit;
        Counters counters;
        frame->trace(std::span(&point, 1), std::span(&hit, 1), counters);
        std::vector<Element> expected = seen_by_ray(coarse, wide, ray_through(view, point.x, point.y));
        const auto is_it = [&](Element element) {
          if (element == background) return hit.element == background;
          const TexelIndex at = texel_index(element);
          return hit.element == texel_element(2, at.i, at.j) && hit.color == coarse.color(at.i, at.j);
        };
        wrong += std::none_of(expected.begin(), expected.end(), is_it) ? 1 : 0;
      }
    }
    CHECK(wrong == 0);
  }
}

}  // namespace

TEST_CASE("the hierarchy of a map of 4 x 4, by hand") {
  Map map{4, 4, {1, 2, 5, 5, 3, 2, 7, 7, 0, 0, 4, 8, 0, 4, 0, 0}, {}};
  for (int k = 0; k < 16; ++k) map.colors.push_back({static_cast<float>(k) / 16, static_cast<float>(k % 4) / 4, 0.5F});
  const SmallTerrain terrain(map);
  // Straight down from high above: 8 pixels across 90 degrees, so that a pixel at the nadir is 1/4 of the height wide.
  View view{.caption = "", .yaw = 0, .pitch = -90, .fov = 90, .far = 100, .size = {8, 8}};
  const auto seen_below = [&](double x, double y, double z) {
    view.x = x;
    view.y = y;
    view.z = z;
    const SamplePoint middle{4.001, 4.001};
    Hit hit;
    Counters counters;
    terrain.frame(view, with_levels(1))->trace(std::span(&middle, 1), std::span(&hit, 1), counters);
    return hit;
  };
  // Level 1 from a slant distance of 2 / (1/4) = 8 to the mean height of 3, level 2 from 16.
  CHECK(seen_below(2.5, 1.5, 10.9).element == texel_element(0, 2, 1));
  CHECK(seen_below(2.5, 1.5, 11.1).element == texel_element(1, 1, 0));
  CHECK(seen_below(2.5, 1.5, 18.9).element == texel_element(1, 1, 0));
  CHECK(seen_below(2.5, 1.5, 19.1).element == texel_element(2, 0, 0));
  CHECK(seen_below(2.5, 1.5, 10.9).color == Color{6 / 16.0F, 2 / 4.0F, 0.5F});
  CHECK(seen_below(2.5, 1.5, 11.1).color == Color{(2 + 3 + 6 + 7) / 64.0F, 2.5F / 4, 0.5F});
  CHECK(seen_below(2.5, 1.5, 19.1).color == Color{7.5F / 16, 1.5F / 4, 0.5F});
  // Beyond the border lie mirrored mean voxels, with indices of their own.
  CHECK(seen_below(-0.5, 1.5, 11.1).element == texel_element(1, -1, 0));
  CHECK(seen_below(-0.5, 1.5, 11.1).color == seen_below(0.5, 1.5, 11.1).color);
  CHECK(seen_below(4.5, 5.5, 19.1).element == texel_element(2, 1, 1));
}

TEST_CASE("where one level fills the view, rays see the boxes, or the walls, of mean height") {
  check_mean_voxels("box", seen_by);
  check_mean_voxels("near", wall_seen_by);
}

TEST_CASE("levels switch at the distances of the rule, rounded up to their own voxels") {
  constexpr double level_constant = 0.9;
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  for (const auto& [yaw, rule] :
       {std::pair(0.0, "floor"), std::pair(30.0, "round"), std::pair(135.0, "floor"), std::pair(250.0, "round")}) {
    View view{.caption = "", .x = 3.3, .y = 5.7, .z = 14, .yaw = yaw, .pitch = -35, .fov = 60, .far = 300};
    view.size = {16, 16};
    const std::vector<double> begin = begins(map, view, level_constant, rule);
    const auto frame = terrain.frame(view, with_levels(level_constant, rule));
    std::set<int> levels;
    for (int y = 0; y < view.size.height; ++y) {
      for (int x = 0; x < view.size.width; ++x) {
        const SamplePoint sample{x + 0.5, y + 0.5};
        SurfacePoint point;
        Counters counters;
        frame->surface()->locate(std::span(&sample, 1), std::span(&point, 1), counters);
        if (!point.textured) continue;
        CAPTURE(yaw, rule, x, y, point.level);
        levels.insert(point.level);
        const double distance = std::hypot(point.s - view.x, point.t - view.y);
        const auto l = static_cast<std::size_t>(point.level);
        REQUIRE(texel_index(point.hit.element).level == point.level);
        REQUIRE(distance >= begin[l] - 1e-6);
        REQUIRE(distance <= begin[l + 1] + std::exp2(point.level + 1) * std::numbers::sqrt2);
      }
    }
    CHECK(levels == std::set<int>{0, 1, 2});
  }
}

TEST_CASE("to round with c over the root of 2 is to round down with c") {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  const auto area = sampler("area");
  for (const View& view : views_all_round()) {
    CAPTURE(view.caption);
    const auto levels_of = [&](double c, const char* rule) {
      const Rendered image = rendered(*area, *terrain.frame(view, with_levels(c, rule)));
      std::vector<std::vector<Element>> elements;
      for (const Content& pixel : image.pixels) {
        elements.emplace_back();
        for (const Fragment& f : pixel.fragments) elements.back().push_back(f.element);
      }
      return elements;
    };
    for (const double c : {0.3, 0.9, 2.5}) {
      CHECK(levels_of(c, "floor") == levels_of(c / std::numbers::sqrt2, "round"));
    }
  }
}

TEST_CASE("area weights fill every pixel with the hierarchy too") {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  for (const char* layout : {"upright", "radial"}) {
    const auto area = sampler("area", {{"layout", std::string(layout)}, {"lines", std::int64_t{2}}});
    for (const View& view : views_all_round()) {
      CAPTURE(layout, view.caption);
      const Rendered image = rendered(*area, *terrain.frame(view, {{"levels", std::string("floor")}}));
      CHECK(std::all_of(image.pixels.begin(), image.pixels.end(),
                        [](const Content& pixel) { return std::abs(pixel.weight - 1) <= 1e-12; }));
    }
  }
}

}  // namespace moire::test
