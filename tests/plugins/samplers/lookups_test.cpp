// How a place on a texture becomes fragments: their weights, on their own and through the sampler `bilinear`.
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "plugins/heightfield/brute_force.h"
#include "plugins/heightfield/small_terrain.h"
#include "sampling/lookups.h"

namespace moire::test {
namespace {

constexpr int columns = 5, rows = 4;

// Texels whose colours rise linearly from west to east and from north to south.
Color ramp(double i, double j) {
  return {static_cast<float>(0.25 + i / 128), static_cast<float>(0.75 - j / 64), static_cast<float>(i / 256 + j / 256)};
}

std::vector<float> ramp_texels(int width, int height) {
  std::vector<float> rgb;
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) {
      const Color color = ramp(i, j);
      rgb.insert(rgb.end(), {color.r, color.g, color.b});
    }
  }
  return rgb;
}

struct Deposit {
  double weight;
  Color color;
  std::vector<Fragment> fragments;
};

// What a lookup makes of a place; `moves_east`: the place moves along s when the image point moves sideways.
Deposit deposit(std::string_view lookup, double s, double t, bool moves_east, double weight = 1) {
  static const std::vector<float> rgb = ramp_texels(columns, rows);
  static const Texture texture({{rgb.data(), 3, columns, rows}}, Wrap::mirror);
  SurfacePoint point;
  point.textured = true;
  point.s = s;
  point.t = t;
  point.hit = texture.texel(0, static_cast<std::int64_t>(std::floor(s)), static_cast<std::int64_t>(std::floor(t)));
  (moves_east ? point.ds_dx : point.dt_dx) = 1;
  Tally tally(1, true);
  make_lookup(lookup)->deposit(point, texture, weight, tally, 0);
  Deposit result{tally.weight(0), tally.color(0), {}};
  tally.for_each(0, [&](const Fragment& f) { result.fragments.push_back(f); });
  return result;
}

bool near(Color a, Color b, float tolerance) {
  return std::abs(a.r - b.r) <= tolerance && std::abs(a.g - b.g) <= tolerance && std::abs(a.b - b.b) <= tolerance;
}

}  // namespace

TEST_CASE("in the middle of a texel every lookup is that texel and nothing else") {
  for (const char* lookup : {"linear_across", "bilinear"}) {
    for (const bool moves_east : {false, true}) {
      for (int j = -3; j < rows + 3; ++j) {
        for (int i = -3; i < columns + 3; ++i) {
          const Deposit found = deposit(lookup, i + 0.5, j + 0.5, moves_east);
          REQUIRE(found.fragments.size() == 1);
          CHECK(found.fragments[0].element == texel_element(0, i, j));
          CHECK(found.weight == 1);
        }
      }
    }
  }
}

TEST_CASE("linear across weighs two texels by 1 - f and f along the axis of sideways motion") {
  const Deposit east = deposit("linear_across", 2.75, 1.9, true, 8);
  REQUIRE(east.fragments.size() == 2);
  CHECK(east.fragments[0].element == texel_element(0, 2, 1));
  CHECK(east.fragments[0].weight == 6);
  CHECK(east.fragments[1].element == texel_element(0, 3, 1));
  CHECK(east.fragments[1].weight == 2);
  const Deposit south = deposit("linear_across", 2.75, 1.125, false, 8);
  REQUIRE(south.fragments.size() == 2);
  CHECK(south.fragments[0].element == texel_element(0, 2, 0));
  CHECK(south.fragments[0].weight == 3);
  CHECK(south.fragments[1].element == texel_element(0, 2, 1));
  CHECK(south.fragments[1].weight == 5);
}

TEST_CASE("bilinear weighs four texels by the products of their nearness") {
  const Deposit found = deposit("bilinear", 2.75, 1.125, true, 32);
  REQUIRE(found.fragments.size() == 4);
  const double weights[] = {9, 3, 15, 5};  // (3/4, 1/4) x (3/8, 5/8) of 32, row by row
  for (int k = 0; k < 4; ++k) {
    const Fragment& fragment = found.fragments[static_cast<std::size_t>(k)];
    CHECK(fragment.element == texel_element(0, 2 + k % 2, k / 2));
    CHECK(fragment.weight == weights[k]);
  }
}

TEST_CASE("over the border the mirrored texel has the border's colour, and is another element") {
  const Deposit found = deposit("bilinear", 0.25, 1.5, true);
  REQUIRE(found.fragments.size() == 2);
  CHECK(found.fragments[0].element == texel_element(0, -1, 1));
  CHECK(found.fragments[1].element == texel_element(0, 0, 1));
  CHECK(found.fragments[0].color == ramp(0, 1));
  CHECK(found.fragments[1].color == ramp(0, 1));
  CHECK(near(deposit("bilinear", columns + 1.5, 1.5, true).color, ramp(columns - 2, 1), 0));
  CHECK(near(deposit("linear_across", 2.5, -0.75, false).color, ramp(2, 0.25), 1e-6F));
}

TEST_CASE("bilinear interpolation of a linear ramp is that ramp") {
  for (double s = 0.5; s <= columns - 0.5; s += 0.0625) {
    for (double t = 0.5; t <= rows - 0.5; t += 0.0625)
      REQUIRE(near(deposit("bilinear", s, t, true).color, ramp(s - 0.5, t - 0.5), 1e-7F));
  }
}

// The ground is flat, so that each ray meets it where a ray meets a plane.
TEST_CASE("the sampler bilinear shows a linear ramp on flat ground exactly, and points under linear across in part") {
  constexpr int side = 64;
  Map map = flat_map(side, side, 2);
  for (int k = 0; k < side * side; ++k) map.colors[static_cast<std::size_t>(k)] = ramp(k % side, k / side);
  const SmallTerrain terrain(map);
  for (const double yaw : {0.0, 33.0, 100.0, 200.0, 315.0}) {
    const View view{.caption = "", .x = 31.3, .y = 32.6, .z = 12, .yaw = yaw, .pitch = -60};
    const auto frame = terrain.frame(view);
    const auto bilinear = make_lookup(sampler_plugin("bilinear").lookup), across = make_lookup("linear_across");
    const Rendered smooth = rendered(*sampler("bilinear"), *frame, bilinear.get());
    const Rendered half_smooth = rendered(*sampler("point"), *frame, across.get());
    for (int y = 0; y < view.size.height; ++y) {
      for (int x = 0; x < view.size.width; ++x) {
        CAPTURE(yaw, x, y);
        const Ray ray = ray_through(view, x + 0.5, y + 0.5);
        const double s = view.x + ray.x * 10 / -ray.z, t = view.y + ray.y * 10 / -ray.z;
        REQUIRE(near(smooth.at(x, y).color, ramp(s - 0.5, t - 0.5), 1e-6F));
        // One axis is interpolated along, the other shows the texel that is hit.
        const Color color = half_smooth.at(x, y).color;
        const bool along_s = near(color, ramp(s - 0.5, std::floor(t)), 1e-6F);
        const bool along_t = near(color, ramp(std::floor(s), t - 0.5), 1e-6F);
        REQUIRE((along_s || along_t));
      }
    }
  }
}

TEST_CASE("linear across interpolates along the axis that a column's walk does not step along") {
  constexpr int side = 64;
  Map map = flat_map(side, side, 2);
  for (int k = 0; k < side * side; ++k) map.colors[static_cast<std::size_t>(k)] = ramp(k % side, k / side);
  const SmallTerrain terrain(map);
  const auto across = make_lookup("linear_across");
  for (const double yaw : {10.0, 80.0, 190.0, 280.0}) {
    const View view{.caption = "", .x = 31.3, .y = 32.6, .z = 12, .yaw = yaw, .pitch = -60};
    const Rendered image = rendered(*sampler("point"), *terrain.frame(view), across.get());
    const int x = view.size.width / 2;
    for (int y = 0; y < view.size.height; ++y) {
      const auto& fragments = image.at(x, y).fragments;
      REQUIRE(fragments.size() == 2);
      const TexelIndex a = texel_index(fragments[0].element), b = texel_index(fragments[1].element);
      const bool walks_along_columns = yaw == 10 || yaw == 190;
      CHECK(b.i - a.i == (walks_along_columns ? 0 : 1));
      CHECK(b.j - a.j == (walks_along_columns ? 1 : 0));
    }
  }
}

}  // namespace moire::test
