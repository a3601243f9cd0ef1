// Exact averages of pixels of worlds that no tolerance was chosen for: random lights, casters and views, and a room.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <random>

#include <moire/document.h>

#include "pixels/pixel_averages.h"
#include "plugins/shadow_planes/adaptive_pixel.h"
#include "plugins/shadow_planes/worlds.h"
#include "sanitized.h"
#include "support/soft_scenes.h"
#include "world/source_file.h"

using namespace shadow_planes;
using namespace shadow_planes::test;

namespace {

constexpr double millionth = 1e-6;

class Random {
 public:
  explicit Random(unsigned seed) : bits_(seed) {}
  double between(double low, double high) { return low + (high - low) * (static_cast<double>(bits_()) * 0x1p-32); }
  int below(int count) { return static_cast<int>(bits_() % static_cast<unsigned>(count)); }

 private:
  std::mt19937 bits_;
};

Vector unit(Vector v) { return (1 / length(v)) * v; }

// Corners on an ellipse of a plane, counterclockwise about its normal.
Convex on_ellipse(Random& random, Vector middle, Vector normal, int corners, double radius, double other_radius) {
  const Vector across = unit(cross(normal, {random.between(-1, 1), random.between(-1, 1), 0.3}));
  const Vector along = cross(normal, across);
  Convex outline;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * (k + random.between(-0.2, 0.2)) / corners;
    outline.push_back(middle + (radius * std::cos(angle)) * across + (other_radius * std::sin(angle)) * along);
  }
  return outline;
}

// A light of 3 to 6 corners, 0.3 to 2 across, 2.5 to 6 above the receiver or askew; the brightest place of the receiver
// has a radiance of 1.
void put_light(Random& random, World& world) {
  const double size = 0.3 * std::pow(2 / 0.3, random.between(0, 1)), lean = std::max(0.0, random.between(-0.7, 0.7));
  const double heading = random.between(0, 2 * std::numbers::pi);
  const Vector normal{std::sin(lean) * std::cos(heading), std::sin(lean) * std::sin(heading), -std::cos(lean)};
  const Vector middle{random.between(-1.5, 1.5), random.between(-1.5, 1.5), random.between(2.5, 6)};
  world.light.plane = {normal, -dot(normal, middle)};
  world.light.parts = {
      on_ellipse(random, middle, normal, 3 + random.below(4), 0.7 * size, 0.7 * size * random.between(0.4, 1))};
  const auto illumination = illumination_of(world, 0, world.faces[0].plane);
  Illumination::Scratch scratch;
  double most = 0;
  for (int k = 0; k < 625; ++k) {
    const Vector at{0.25 * (k % 25 - 12), 0.25 * (k / 25 - 12), 0};
    most = std::max(most, illumination->at(at, {}, scratch).irradiance);
  }
  const auto color = static_cast<float>(std::numbers::pi / most);
  world.light.color = {color, color, color};
}

// Triangles and quadrilaterals of any direction, between receiver and light.
void put_caster(Random& random, World& world) {
  double light = world.light.parts[0][0].z;
  for (const Vector& p : world.light.parts[0]) light = std::min(light, p.z);
  for (;;) {
    const Vector middle{random.between(-1.6, 1.6), random.between(-1.6, 1.6), light * random.between(0.15, 0.6)};
    const Vector normal = unit({random.between(-1, 1), random.between(-1, 1), random.between(0.2, 1.5)});
    const double size = random.between(0.25, 0.8);
    const Convex outline = on_ellipse(random, middle, normal, 3 + random.below(2), size, size * random.between(0.3, 1));
    const auto is_between = [&](const Vector& p) { return p.z > 0.02 && p.z < light - 0.05; };
    if (!std::all_of(outline.begin(), outline.end(), is_between)) continue;
    world.faces.push_back(face_of(outline));
    return;
  }
}

// Whether somewhere two casters hide one part of the light.
bool any_overlap(const World& world) {
  const auto illumination = illumination_of(world, 0, world.faces[0].plane);
  Illumination::Scratch scratch;
  constexpr int fine = 120;
  for (int k = 0; k < fine * fine; ++k) {
    const Vector at{6.0 * (k % fine) / (fine - 1) - 3, 6.0 * (k / fine) / (fine - 1) - 3, 0};
    illumination->at(at, illumination->all(), scratch);
    if (scratch.overlap) return true;
  }
  return false;
}

// One to three casters, no two of which hide one part of the light.
World disjoint_world(Random& random, int casters) {
  for (;;) {
    World world = lit_receiver();
    put_light(random, world);
    for (int k = 0; k < casters; ++k) put_caster(random, world);
    if (!any_overlap(world)) return world;
  }
}

// From 6 to 34 degrees above the receiver, from any side.
Camera low_view(Random& random, moire::ImageSize size) {
  Camera camera;
  camera.size = size;
  const double pitch = random.between(0.1, 0.6), heading = random.between(0, 2 * std::numbers::pi);
  camera.ahead = {std::cos(pitch) * std::cos(heading), std::cos(pitch) * std::sin(heading), -std::sin(pitch)};
  camera.right = {std::sin(heading), -std::cos(heading), 0};
  camera.down = cross(camera.ahead, camera.right);
  camera.eye = Vector{0, 0, 0.1} - random.between(3, 7) * camera.ahead;
  camera.focal = random.between(0.8, 1.2) * size.width;
  return camera;
}

struct Rendered {
  moire::PixelBlock block;
  double bound;
};

Rendered rendered(const World& world, const Camera& camera, const VisibleParts& visible, double tolerance) {
  Rendered result{moire::PixelBlock({0, 0, camera.size.width, camera.size.height}, false), 0};
  result.bound = PixelAverages(world, camera, visible, {tolerance, false}).integrate(nullptr, result.block);
  return result;
}

double largest(const moire::Tally::Sum& p, const moire::Tally::Sum& q) {
  return std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
}

}  // namespace

TEST_CASE("worlds under random lights have pixels to a millionth, and to their bound", "[shadow_planes]") {
  constexpr int size = 48, tried = 3;
  constexpr double fine = 1e-9;
  Random random(2027);
  for (int trial = 0; trial < (moire::test::sanitized ? 2 : 6); ++trial) {
    const World world = disjoint_world(random, 1 + trial % 3);
    const World receiver = only_receiver(world);
    for (const bool is_low : {false, true}) {
      INFO("world " << trial << (is_low ? ", low" : ", from above"));
      const Camera camera = is_low ? low_view(random, {size, size}) : overhead({size, size});
      const VisibleParts visible(receiver, camera);
      const Rendered exact = rendered(world, camera, visible, PixelAverages::Options{}.tolerance);
      const Rendered truth = rendered(world, camera, visible, fine);
      double worst = 0;
      int at = 0;
      for (int k = 0; k < size * size; ++k) {
        const std::size_t slot = exact.block.slot(k % size, k / size);
        const double error = largest(exact.block.sum(slot), truth.block.sum(slot));
        if (error > worst) worst = error, at = k;
      }
      CHECK(worst > 0);
      CHECK(worst <= millionth);
      CHECK(worst <= exact.bound + truth.bound);
      // The truth itself, where it differs most and anywhere, by quadrature that shares no rule with it.
      AdaptivePixel adaptive(world, camera);
      const double light = world.light.color.r / std::numbers::pi;
      std::vector<Part> parts;
      for (int k = 0; k < tried; ++k) {
        const int pixel = k == 0 ? at : random.below(size * size);
        const int x = pixel % size, y = pixel / size;
        visible.in({x + 0.0, y + 0.0, x + 1.0, y + 1.0}, parts);
        if (parts.size() != 1 || parts[0].face != 0) continue;
        const auto result = adaptive.over(x, y, 1, 1e-9 / light);
        const double noise = 3 * light * std::sqrt(result.squared_error);
        CHECK(std::abs(truth.block.sum(truth.block.slot(x, y)).r - light * result.value) <= 3e-8 + noise);
      }
    }
  }
}

TEST_CASE("a room has pixels to their bound", "[shadow_planes]") {
  constexpr moire::ImageSize size{moire::test::sanitized ? 48 : 120, moire::test::sanitized ? 32 : 80};
  const moire::Settings settings = moire::test::shadow_settings(
      {{"light.distance", 400.0}, {"view.x", 150.0}, {"view.y", -750.0}, {"view.z", 450.0}, {"view.target_z", 70.0}});
  const Source source = read_source(moire::Document(std::filesystem::path(MOIRE_ROOM)));
  World world;
  world.faces = source.faces;
  share_planes(world.faces);
  world.light = light_of(source.light, settings);
  const Camera camera = camera_of(settings, size);
  const VisibleParts visible(world, camera);
  const Rendered exact = rendered(world, camera, visible, PixelAverages::Options{}.tolerance);
  const Rendered truth = rendered(world, camera, visible, 1e-9);
  double worst = 0;
  for (std::size_t slot = 0; slot < exact.block.slots(); ++slot) {
    worst = std::max(worst, largest(exact.block.sum(slot), truth.block.sum(slot)));
  }
  CHECK(worst > 0);
  CHECK(worst <= exact.bound + truth.bound);
}
