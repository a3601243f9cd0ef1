// Casters and lights where signs, sums and limits go wrong if nothing is done about it.
#include <cmath>
#include <numbers>

#include "light/illumination.h"
#include "support/light_truth.h"
#include "support/soft_scenes.h"

using namespace shadow_planes;
using namespace shadow_planes::test;

namespace {

Reach reach_of(const World& world, Vector x, Vector up = {0, 0, 1}) {
  Plane side = world.faces[0].plane;
  if (dot(side.normal, up) < 0) side = {-side.normal, -side.d};
  const auto illumination = illumination_of(world, 0, side);
  Illumination::Scratch scratch;
  return illumination->at(x, illumination->all(), scratch);
}

// The receiver z = 0 under another light, which shines along the normal of its outline.
World under(const Convex& light) {
  World world = lit_receiver();
  world.light.plane = face_of(light).plane;
  world.light.parts = {light};
  return world;
}

}  // namespace

TEST_CASE("coplanar duplicates change no bit", "[shadow_planes]") {
  for (const SoftScene& scene : soft_scenes()) {
    INFO(scene.name);
    World twice = scene.world;
    for (std::size_t k = 1; k < scene.world.faces.size(); ++k) twice.faces.push_back(scene.world.faces[k]);
    for (int k = 0; k < 900; ++k) {
      const Vector x{-2.9 + 0.2 * (k % 30), -2.9 + 0.2 * (k / 30), 0};
      const Reach once = reach_of(scene.world, x), again = reach_of(twice, x);
      REQUIRE(once.irradiance == again.irradiance);
      REQUIRE(once.lit == again.lit);
    }
  }
}

TEST_CASE("tiles that share edges let no light through and hide none twice", "[shadow_planes]") {
  // 3 x 3 tiles of a tilted quad, corners computed once.
  const Vector corner{-0.9, -0.8, 1.1}, s{0.61, 0.07, 0.1}, t{-0.05, 0.57, 0.13};
  World whole = lit_receiver(), tiled = whole;
  whole.faces.push_back(face_of({corner, corner + 3 * s, corner + 3 * s + 3 * t, corner + 3 * t}));
  const auto at = [&](int i, int j) { return corner + static_cast<double>(i) * s + static_cast<double>(j) * t; };
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      tiled.faces.push_back(face_of({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}));
    }
  }
  int dark = 0;
  for (int k = 0; k < 3600; ++k) {
    const Vector x{-2.9 + 0.1 * (k % 60), -2.9 + 0.1 * (k / 60), 0};
    const Reach one = reach_of(whole, x), nine = reach_of(tiled, x);
    REQUIRE((one.lit == 0) == (nine.lit == 0));
    REQUIRE(std::abs(one.irradiance - nine.irradiance) <= 3e-16);  // of some .06: a few roundings of nine differences
    REQUIRE(std::abs(one.lit - nine.lit) <= 3e-15);
    dark += one.lit == 0;
  }
  CHECK(dark > 50);
}

TEST_CASE("a point in a caster's plane is not darkened by it", "[shadow_planes]") {
  World world = lit_receiver();
  const double open = reach_of(world, {0.25, 0.5, 0}).irradiance;
  world.faces.push_back(face_of(rectangle({0.25, -2, 0}, {0, 4, 0}, {0, 0, 1})));  // a wall, its foot through the point
  CHECK(reach_of(world, {0.25, 0.5, 0}).irradiance == open);
  CHECK(reach_of(world, {0.25, 2.5, 0}).irradiance == reach_of(lit_receiver(), {0.25, 2.5, 0}).irradiance);
  // Slanted walls through points that are not exact in their planes.
  World slanted = lit_receiver();
  slanted.faces.push_back(face_of(rectangle({-1.1, -0.7, 0}, {2.2, 1.3, 0}, {0.1, 0.3, 1.2})));
  for (int k = 1; k < 100; ++k) {
    const Vector x = Vector{-1.1, -0.7, 0} + (0.01 * k) * Vector{2.2, 1.3, 0};
    REQUIRE(reach_of(slanted, x).irradiance == reach_of(lit_receiver(), x).irradiance);
  }
}

TEST_CASE("a caster that is tilted out of the point's plane takes light in proportion", "[shadow_planes]") {
  // A light that straddles the plane x = 0; a blade from beside the point, all but in that plane.
  const double open = reach_of(lit_receiver(), {0, 0, 0}).irradiance;
  double before = 0;
  for (const double tilt : {1e-3, 1e-5, 1e-7, 1e-9}) {
    World world = lit_receiver();
    world.faces.push_back(face_of(rectangle({0, -1, 1}, {0, 2, 0}, {tilt, 0, 1})));
    world.faces.back().parts[0][0].x = world.faces.back().parts[0][1].x = -tilt;
    world.faces.back() = face_of(world.faces.back().parts[0]);
    const double taken = (open - reach_of(world, {0, 0, 0}).irradiance) / tilt;
    CHECK(taken > 0);
    // At 1e-9 eight digits are left.
    if (before > 0) CHECK(std::abs(taken / before - 1) <= 1e-2 * std::max(1e-2, 1e-13 / tilt));
    before = taken;
  }
}

TEST_CASE("what is behind the receiver or beyond the light hides nothing, and what crosses is cut", "[shadow_planes]") {
  const Vector x{0.3, 0.2, 0};
  const double open = reach_of(lit_receiver(), x).irradiance;
  World world = lit_receiver();
  world.faces.push_back(face_of(rectangle({-3, -3, -1}, {6, 0, 0}, {0, 6, 0})));
  world.faces.push_back(face_of(rectangle({-3, -3, 4.5}, {6, 0, 0}, {0, 6, 0})));
  world.faces.push_back(face_of(rectangle({-3, -3, 0}, {6, 0, 0}, {0, 6, 0})));  // in the receiver's plane
  CHECK(reach_of(world, x).irradiance == open);
  // A wall through both planes hides what the same wall between them hides.
  World through = lit_receiver(), between = lit_receiver();
  through.faces.push_back(face_of(rectangle({0.4, -1, -2}, {0, 2, 0}, {0, 0, 9})));
  between.faces.push_back(face_of(rectangle({0.4, -1, 0}, {0, 2, 0}, {0, 0, 4})));
  CHECK(std::abs(reach_of(through, x).irradiance - reach_of(between, x).irradiance) <= 1e-16);
  CHECK(reach_of(through, x).lit < 1);
}

TEST_CASE("a caster in the light's plane hides its share of the light", "[shadow_planes]") {
  const auto with_cover = [&](double below) {
    World world = lit_receiver();
    world.faces.push_back(face_of(rectangle({-0.3, -0.2, 4 - below}, {0.5, 0, 0}, {0, 0.4, 0})));
    return reach_of(world, {0.3, 0.2, 0});
  };
  CHECK(std::abs(with_cover(0).lit - 0.8) <= 1e-14);
  CHECK(std::abs(with_cover(0).irradiance - with_cover(1e-9).irradiance) <= 1e-10);
}

TEST_CASE("faces without area and needles take no light", "[shadow_planes]") {
  const double open = reach_of(lit_receiver(), {0.1, 0, 0}).irradiance;
  World world = lit_receiver();
  Face line = face_of(rectangle({-1, 0, 1}, {2, 0, 0}, {0, 1, 0}));
  line.parts = {{{-1, 0, 1}, {1, 0, 1}, {0.3, 0, 1}}};
  world.faces.push_back(line);
  line.parts = {{{-1, 0, 1}, {1, 0, 1}, {1, 0, 1}, {-1, 0, 1}}};
  world.faces.push_back(line);
  line.parts.clear();
  world.faces.push_back(line);
  CHECK(reach_of(world, {0.1, 0, 0}).irradiance == open);
  line.parts = {{{-1, 0, 1}, {1, 0, 1}, {1, 1e-14, 1}}};  // takes some 1e-14 of the light, and no more
  world.faces.push_back(line);
  CHECK(std::abs(reach_of(world, {0.1, 0, 0}).irradiance - open) <= 5e-14 * open);
}

TEST_CASE("a light that the receiver's plane cuts counts as far as it is before it", "[shadow_planes]") {
  // Upright, from -1 to 1 in height, seen from 4 away: the lower half is out of sight, but makes half of its area.
  const World world = under(rectangle({4, -0.5, -1}, {0, 1, 0}, {0, 0, 2}));
  const Vector towards = world.light.plane.normal;
  World facing = world;
  if (towards.x > 0) facing = under(rectangle({4, -0.5, -1}, {0, 0, 2}, {0, 1, 0}));
  const World upper = under(rectangle({4, -0.5, 0}, {0, 0, 1}, {0, 1, 0}));
  REQUIRE(upper.light.plane.normal.x < 0);
  const Reach cut = reach_of(facing, {0, 0, 0}), whole = reach_of(upper, {0, 0, 0});
  CHECK(std::abs(cut.irradiance - whole.irradiance) <= 1e-17);
  CHECK(std::abs(cut.lit - 0.5) <= 1e-15);
  CHECK(std::abs(whole.irradiance - light_truth(upper, 0, {0, 0, 0}, {0, 0, 1}).irradiance) <= 1e-16);
  // The sum over the light uncut counts the lower half as negative light.
  CHECK(whole.irradiance > 0.005);
}

TEST_CASE("a light in the receiver's plane or turned away brings nothing", "[shadow_planes]") {
  CHECK(reach_of(under(rectangle({1, 1, 0}, {1, 0, 0}, {0, 1, 0})), {0, 0, 0}).irradiance == 0);
  CHECK(reach_of(under(rectangle({1, 1, 0}, {0, 1, 0}, {1, 0, 0})), {0, 0, 0}).irradiance == 0);
  CHECK(reach_of(under(rectangle({-1, -1, 2}, {2, 0, 0}, {0, 2, 0})), {0, 0, 0}).lit == 0);  // shines upwards
  CHECK(reach_of(lit_receiver(), {0, 0, 0}, {0, 0, -1}).lit == 0);                           // seen from below
}

TEST_CASE("beside a standing light half of all light arrives", "[shadow_planes]") {
  const World world = under(rectangle({0, -1, 0}, {0, 0, 2}, {0, 2, 0}));  // shines along -x
  REQUIRE(world.light.plane.normal.x < 0);
  const double share = reach_of(world, {-1e-6, 0, 0}).irradiance / std::numbers::pi;
  CHECK(share < 0.5);
  CHECK(std::abs(share - 0.5) < 1e-6);
  CHECK(reach_of(world, {-1e-300, 0, 0}).irradiance <= std::numbers::pi / 2 * (1 + 1e-15));
  CHECK(reach_of(world, {1e-6, 0, 0}).irradiance == 0);
}

TEST_CASE("small and distant lights keep their digits", "[shadow_planes]") {
  for (const double size : {2.5e-2, 1.01e-3 * 4, 0.99e-3 * 4, 2.5e-3, 2.5e-5, 2.5e-7, 2.5e-9}) {
    INFO(size);
    const World world = under(rectangle({-size / 2, -size / 2, 4}, {0, size, 0}, {size, 0, 0}));
    const Vector x{0.7, -0.4, 0};
    const double truth = light_truth(world, 0, x, {0, 0, 1}).irradiance;
    // Where Lambert's sum is still used its terms, of length size, cancel to size^2: at 4e-3 four digits are lost.
    const double relative = size < 4e-3 ? 1e-14 : 1e-15 * (16 / (size * size));
    CHECK(std::abs(reach_of(world, x).irradiance / truth - 1) <= relative);
    // Half of it hidden.
    World half = world;
    half.faces.push_back(face_of(rectangle({0.35, -3, 2}, {2, 0, 0}, {0, 6, 0})));
    CHECK(std::abs(reach_of(half, x).irradiance / light_truth(half, 0, x, {0, 0, 1}).irradiance - 1) <=
          std::max(relative, 1e-14 / size));
  }
}

TEST_CASE("a light of several parts is the sum of them", "[shadow_planes]") {
  World world = soft_scenes()[3].world, parts = world;
  const Convex light = world.light.parts[0];
  const Vector middle = 0.5 * (light[0] + light[1]), opposite = 0.5 * (light[2] + light[3]);
  parts.light.parts = {{light[0], middle, opposite, light[3]}, {middle, light[1], light[2], opposite}};
  for (int k = 0; k < 900; ++k) {
    const Vector x{-2.9 + 0.2 * (k % 30), -2.9 + 0.2 * (k / 30), 0};
    const Reach one = reach_of(world, x), two = reach_of(parts, x);
    REQUIRE(std::abs(one.irradiance - two.irradiance) <= 2e-16);
    REQUIRE(std::abs(one.lit - two.lit) <= 2e-15);
  }
}
