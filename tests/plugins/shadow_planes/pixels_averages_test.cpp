// Exact averages of pixels, against adaptive quadrature that knows of no critical line, and against areas on paper.
#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "pixels/pixel_averages.h"
#include "plugins/shadow_planes/adaptive_pixel.h"
#include "support/soft_scenes.h"

using namespace shadow_planes;
using namespace shadow_planes::test;

namespace {

moire::PixelBlock rendered(const PixelAverages& averages, moire::PixelArea area, bool recording = false) {
  moire::PixelBlock block(area, recording);
  averages.integrate(nullptr, block);
  return block;
}

}  // namespace

TEST_CASE("pixel averages are those of adaptive quadrature, to a millionth of the light", "[shadow_planes]") {
  constexpr int size = 96;
  std::mt19937 random(5);
  for (const bool is_grazing : {false, true}) {
    const Camera camera = is_grazing ? grazing({size, size}) : overhead({size, size});
    for (const SoftScene& scene : soft_scenes()) {
      INFO(scene.name << (is_grazing ? ", grazing" : ", from above"));
      // The receiver as seen through the casters.
      const VisibleParts visible(only_receiver(scene.world), camera);
      const PixelAverages averages(scene.world, camera, visible);
      moire::PixelBlock block({0, 0, size, size}, false);
      const double bound = averages.integrate(nullptr, block);
      CHECK(bound > 0);
      CHECK(bound <= 1e-5);
      AdaptivePixel truth(scene.world, camera);
      const double light = scene.world.light.color.r / std::numbers::pi;
      std::vector<Part> parts;
      int tried = 0;
      double worst = 0;
      while (tried < 40) {
        const auto x = static_cast<int>(random() % size), y = static_cast<int>(random() % size);
        visible.in({x + 0.0, y + 0.0, x + 1.0, y + 1.0}, parts);
        if (parts.size() != 1 || parts[0].face != 0) continue;
        // Half of them where something is going on.
        const double here = block.sum(block.slot(x, y)).r;
        const double beside = block.sum(block.slot(std::min(x + 1, size - 1), y)).r;
        if (tried % 2 == 0 && std::abs(here - beside) < 0.01 && random() % 64 != 0) continue;
        ++tried;
        const auto result = truth.over(x, y, 1, 1e-10 / light);
        const double noise = 3 * light * std::sqrt(result.squared_error);
        if (noise < 1e-6) worst = std::max(worst, std::abs(here - light * result.value));
        CHECK(std::abs(here - light * result.value) <= 1e-6 + noise);
      }
      CHECK(worst > 0);
    }
  }
}

TEST_CASE("fragments of a pixel make up its area and its colour", "[shadow_planes]") {
  constexpr int size = 64;
  for (SoftScene& scene : soft_scenes()) {
    INFO(scene.name);
    scene.world.ambient = {0.1F, 0.2F, 0.3F};
    scene.world.faces[0].reflectance = {0.5F, 0.6F, 0.7F};
    const Camera camera = grazing({size, size});
    const VisibleParts visible(scene.world, camera);
    const PixelAverages averages(scene.world, camera, visible);
    const moire::PixelBlock block = rendered(averages, {0, 0, size, size}, true);
    std::size_t shadows = 0;
    for (std::size_t slot = 0; slot < block.slots(); ++slot) {
      double weight = 0, green = 0;
      block.for_each(slot, [&](const moire::Fragment& f) {
        REQUIRE(f.weight > 0);
        weight += f.weight;
        green += f.weight * f.color.g;
        shadows += f.element == shadowed(0, 1);
      });
      REQUIRE(std::abs(weight - 1) <= 1e-12);
      REQUIRE(std::abs(block.weight(slot) - 1) <= 1e-12);
      REQUIRE(std::abs(green - block.sum(slot).g) <= 1e-6 * (1 + green));  // colours of fragments are floats
    }
    CHECK(shadows > 10);
  }
}

TEST_CASE("no bit depends on the block's shape or on recording", "[shadow_planes]") {
  constexpr int size = 50;  // no multiple of a tile
  const SoftScene scene = soft_scenes()[3];
  const Camera camera = grazing({size, size});
  const VisibleParts visible(scene.world, camera);
  const PixelAverages averages(scene.world, camera, visible);
  const moire::PixelBlock whole = rendered(averages, {0, 0, size, size});
  for (const moire::PixelArea shape : {moire::PixelArea{0, 0, 7, 50}, {0, 0, 50, 1}, {0, 0, 13, 9}}) {
    std::uint64_t queries = 0;
    for (int y = 0; y < size; y += shape.height) {
      for (int x = 0; x < size; x += shape.width) {
        const moire::PixelArea area{x, y, std::min(shape.width, size - x), std::min(shape.height, size - y)};
        const moire::PixelBlock block = rendered(averages, area, x % 2 == 0);
        queries += block.counters.queries;
        for (int j = y; j < y + area.height; ++j) {
          for (int i = x; i < x + area.width; ++i) {
            REQUIRE(block.sum(block.slot(i, j)) == whole.sum(whole.slot(i, j)));
          }
        }
      }
    }
    CHECK(queries == whole.counters.queries);
  }
}

TEST_CASE("who shadows a pixel is who shadows its points", "[shadow_planes]") {
  constexpr int size = 48, fine = 24;
  const SoftScene scene = soft_scenes()[3];
  const Camera camera = overhead({size, size});
  const VisibleParts visible(only_receiver(scene.world), camera);
  const PixelAverages averages(scene.world, camera, visible);
  const moire::PixelBlock block = rendered(averages, {0, 0, size, size}, true);
  const auto illumination = illumination_of(scene.world, 0, scene.world.faces[0].plane);
  Illumination::Scratch scratch;
  for (int pixel = 0; pixel < size * size; pixel += 7) {
    const int x = pixel % size, y = pixel / size;
    std::map<moire::Element, double> sums;
    for (int k = 0; k < fine * fine; ++k) {
      const Vector ray = camera.ray({x + (k % fine + 0.5) / fine, y + (k / fine + 0.5) / fine});
      const Reach reach = illumination->at(camera.eye - (camera.eye.z / ray.z) * ray, illumination->all(), scratch);
      sums[lit(0)] += reach.lit / (fine * fine);
      for (const auto& [caster, share] : scratch.hidden) {
        sums[shadowed(0, illumination->casters()[caster].face)] += share / (fine * fine);
      }
    }
    block.for_each(block.slot(x, y), [&](const moire::Fragment& f) { sums[f.element] -= f.weight; });
    // Points miss jumps, such as at the wall's foot, by up to a row of them.
    for (const auto& [element, difference] : sums) REQUIRE(std::abs(difference) <= 1.0 / fine);
  }
}

TEST_CASE("hard shadows of a point light have their exact area, shaded or flat", "[shadow_planes]") {
  constexpr int size = 64;
  World world = lit_receiver();
  world.light.kind = LightKind::point;
  world.light.place = {0.1, -0.2, 4};
  world.light.color = world.light.flat = {1, 1, 1};
  world.faces.push_back(face_of({{0.83, 0.2, 1}, {0.3, 0.91, 1}, {-0.4, 0.1, 1}, {0.2, -0.5, 1}}));
  const Camera camera = overhead({size, size});
  const VisibleParts visible(only_receiver(world), camera);
  // A caster 1 up casts a shadow (4 / 3)^2 as large.
  Outline outline;
  for (const Vector& p : world.faces[1].parts[0]) outline.push_back({p.x, p.y});
  const double area = 0.5 * doubled_area(outline) * 16 / 9, pixel = 36.0 / (size * size);
  for (const bool is_flat : {false, true}) {
    const PixelAverages averages(world, camera, visible, {3e-7, is_flat});
    const moire::PixelBlock block = rendered(averages, {0, 0, size, size}, true);
    double dark = 0, light = 0;
    for (std::size_t slot = 0; slot < block.slots(); ++slot) {
      light += block.sum(slot).r * pixel;
      block.for_each(slot,
                     [&](const moire::Fragment& f) { dark += f.element == shadowed(0, 1) ? f.weight * pixel : 0; });
    }
    CHECK(std::abs(dark - area) <= 1e-10);
    if (is_flat) CHECK(std::abs(light - (36 - area)) <= 1e-10);
  }
}

TEST_CASE("faces that no light reaches, the sky and empty worlds have averages", "[shadow_planes]") {
  constexpr int size = 32;
  World world = lit_receiver();
  world.light.plane = {{0, 0, 1}, -4};  // shines upward
  std::reverse(world.light.parts[0].begin(), world.light.parts[0].end());
  world.ambient = {0.25F, 0.25F, 0.25F};
  const Camera camera = grazing({size, size});
  const VisibleParts visible(world, camera);
  const moire::PixelBlock dark = rendered(PixelAverages(world, camera, visible), {0, 0, size, size}, true);
  bool some_sky = false, some_face = false;
  for (std::size_t slot = 0; slot < dark.slots(); ++slot) {
    dark.for_each(slot, [&](const moire::Fragment& f) {
      CHECK((f.element == moire::background || f.element == unlit(0)));
      CHECK(f.color.r == (f.element == moire::background ? world.sky.r : 0.25F));
      some_sky |= f.element == moire::background;
      some_face |= f.element == unlit(0);
    });
  }
  CHECK(some_sky);
  CHECK(some_face);
  World nothing;
  const VisibleParts sky(nothing, camera);
  const moire::PixelBlock empty = rendered(PixelAverages(nothing, camera, sky), {3, 4, 5, 6});
  for (std::size_t slot = 0; slot < empty.slots(); ++slot) CHECK(empty.color(slot).b == nothing.sky.b);
}

TEST_CASE("copies of a face in its plane, whole or in part, leave averages as they are", "[shadow_planes]") {
  const World one = lit_receiver();
  World copies = one;
  copies.faces.push_back(one.faces[0]);
  copies.faces.push_back(one.faces[0]);
  for (Convex& part : copies.faces.back().parts) {
    for (Vector& p : part) p = 0.3 * p;
  }
  // Where rounding leaves slivers between the copies depends on where their edges fall.
  for (int width = 60; width <= 100; ++width) {
    CAPTURE(width);
    Camera camera = grazing({width, 40});
    camera.eye = Vector{0, 0, 0.3} - 0.07 * width * camera.ahead;
    camera.focal = 0.5 * width;  // the whole of it is in view
    const VisibleParts alone(one, camera), together(copies, camera);
    const moire::PixelBlock expected = rendered(PixelAverages(one, camera, alone), {0, 0, width, 40});
    const moire::PixelBlock found = rendered(PixelAverages(copies, camera, together), {0, 0, width, 40});
    double worst = 0;
    for (std::size_t slot = 0; slot < found.slots(); ++slot)
      worst = std::max(worst, std::abs(static_cast<double>(found.color(slot).g) - expected.color(slot).g));
    CHECK(worst <= 2e-6);
  }
}
