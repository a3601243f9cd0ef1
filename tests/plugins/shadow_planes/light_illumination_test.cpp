// Irradiance and visible share at points, against quadrature of independently found pieces and against many points of
// the light.
#include "light/illumination.h"

#include <cmath>
#include <random>

#include "support/light_truth.h"
#include "support/soft_scenes.h"

using namespace shadow_planes;
using namespace shadow_planes::test;

namespace {

// In units of what reaches the point under the light.
constexpr double under_light = 0.0615;

// Whether the segment from x to y meets a caster, by its crossing with the plane and the edges there.
bool hidden(const World& world, Vector x, Vector y) {
  for (std::size_t k = 1; k < world.faces.size(); ++k) {
    const Face& face = world.faces[k];
    const double at_x = face.plane.distance(x), at_y = face.plane.distance(y);
    if ((at_x > 0) == (at_y > 0)) continue;
    const Vector meeting = x + (at_x / (at_x - at_y)) * (y - x);
    for (const Convex& part : face.parts) {
      bool within = true;
      for (std::size_t c = 0; c < part.size() && within; ++c) {
        const Vector edge = part[(c + 1) % part.size()] - part[c];
        within = dot(cross(edge, meeting - part[c]), face.plane.normal) >= 0;
      }
      if (within) return true;
    }
  }
  return false;
}

}  // namespace

TEST_CASE("irradiance is that of quadrature over what casters leave of the light", "[shadow_planes]") {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> place(-2.9, 2.9);
  for (const SoftScene& scene : soft_scenes()) {
    INFO(scene.name);
    const auto illumination = illumination_of(scene.world, 0, scene.world.faces[0].plane);
    Illumination::Scratch scratch;
    double worst = 0, worst_lit = 0;
    int penumbra = 0;
    for (int k = 0; k < 400; ++k) {
      const Vector x{place(random), place(random), 0};
      const Reach reach = illumination->at(x, illumination->all(), scratch);
      const LightTruth truth = light_truth(scene.world, 0, x, {0, 0, 1});
      worst = std::max(worst, std::abs(reach.irradiance - truth.irradiance) / under_light);
      worst_lit = std::max(worst_lit, std::abs(reach.lit - truth.lit));
      double sum = reach.lit;
      for (const auto& [caster, share] : scratch.hidden) sum += share;
      CHECK(std::abs(sum - 1) <= 1e-14);
      // Casters that hide nothing change no bit.
      const std::vector<std::uint32_t> met = scratch.met;
      const Reach again = illumination->at(x, met, scratch);
      CHECK(again.irradiance == reach.irradiance);
      CHECK(again.lit == reach.lit);
      penumbra += reach.lit > 0 && reach.lit < 1;
    }
    CHECK(penumbra > 20);
    CHECK(worst <= 1e-14);
    CHECK(worst_lit <= 1e-14);
  }
}

TEST_CASE("a million jittered points of the light agree with the closed form within their noise", "[shadow_planes]") {
  constexpr int side = 1000;
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const SoftScene& scene : soft_scenes()) {
    INFO(scene.name);
    const auto illumination = illumination_of(scene.world, 0, scene.world.faces[0].plane);
    Illumination::Scratch scratch;
    const Convex& light = scene.world.light.parts[0];
    const Vector u = light[1] - light[0], v = light[3] - light[0];
    int tried = 0;
    while (tried < 3) {
      const Vector x{6 * unit(random) - 3, 6 * unit(random) - 3, 0};
      const Reach reach = illumination->at(x, illumination->all(), scratch);
      if (reach.lit == 0 || reach.lit == 1) continue;
      ++tried;
      double irradiance = 0, lit = 0;
      for (int i = 0; i < side; ++i) {
        for (int j = 0; j < side; ++j) {
          const Vector y = light[0] + ((i + unit(random)) / side) * u + ((j + unit(random)) / side) * v;
          if (hidden(scene.world, x, y)) continue;
          const Vector r = y - x;
          const double squared = dot(r, r);
          lit += 1;
          irradiance += r.z * r.z / (squared * squared);
        }
      }
      lit /= side * side, irradiance /= side * side;
      // Only strata on edges are uncertain: of standard deviation 1/2 at most, about 2 * side for each of up to 16
      // edges that cross the light. Five standard deviations.
      const double noise = 5 * 0.5 * std::sqrt(16.0 * 2 * side) / (side * side);
      CHECK(std::abs(lit - reach.lit) <= noise);
      CHECK(std::abs(irradiance - reach.irradiance) <= noise * under_light);
    }
  }
}

TEST_CASE("each caster gets what it hides first", "[shadow_planes]") {
  World world = lit_receiver();
  const Vector x{0.2, -0.1, 0};
  // Across one half of the light, then across all of it.
  world.faces.push_back(face_of(rectangle({0.1, -2, 2}, {3, 0, 0}, {0, 4, 0})));
  world.faces.push_back(face_of(rectangle({-2, -2, 1}, {4, 0, 0}, {0, 4, 0})));
  const auto illumination = illumination_of(world, 0, world.faces[0].plane);
  Illumination::Scratch scratch;
  World alone = world;
  alone.faces.pop_back();
  const double half = 1 - light_truth(alone, 0, x, {0, 0, 1}).lit;
  const Reach reach = illumination->at(x, illumination->all(), scratch);
  CHECK(reach.lit == 0);
  CHECK(reach.irradiance == 0);
  REQUIRE(scratch.hidden.size() == 2);
  CHECK(std::abs(scratch.hidden[0].share - half) <= 1e-14);
  CHECK(std::abs(scratch.hidden[1].share - (1 - half)) <= 1e-14);
  CHECK(scratch.overlap);
}

TEST_CASE("point and directional lights are hidden by what lies between, and only by that", "[shadow_planes]") {
  World world = lit_receiver();
  world.light.kind = LightKind::point;
  world.light.place = {0, 0, 4};
  world.faces.push_back(face_of(rectangle({-0.5, -0.5, 1}, {1, 0, 0}, {0, 1, 0})));
  world.faces.push_back(face_of(rectangle({-5, -5, 5}, {10, 0, 0}, {0, 10, 0})));   // beyond the light
  world.faces.push_back(face_of(rectangle({-5, -5, -1}, {10, 0, 0}, {0, 10, 0})));  // behind the receiver
  const auto point = illumination_of(world, 0, world.faces[0].plane);
  Illumination::Scratch scratch;
  CHECK(point->at({0.6, 0, 0}, point->all(), scratch).lit == 0);  // the shadow reaches 2/3 out
  REQUIRE(scratch.hidden.size() == 1);
  CHECK(point->casters()[scratch.hidden[0].caster].face == 1);
  const Reach reach = point->at({0.7, 0, 0}, point->all(), scratch);
  CHECK(reach.lit == 1);
  CHECK(std::abs(reach.irradiance - 4 / std::pow(0.49 + 16, 1.5)) <= 1e-16);
  world.light.kind = LightKind::directional;
  world.light.place = {0.6, 0, 0.8};
  const auto sun = illumination_of(world, 0, world.faces[0].plane);
  CHECK(sun->at({0, 0, 0}, sun->all(), scratch).lit == 0);  // now the high face is in between
  world.faces[2].casts = false;
  const auto clear = illumination_of(world, 0, world.faces[0].plane);
  CHECK(clear->at({0, 0, 0}, clear->all(), scratch).irradiance == 0.8);
  CHECK(clear->at({-0.7, 0, 0}, clear->all(), scratch).lit == 0);
}
