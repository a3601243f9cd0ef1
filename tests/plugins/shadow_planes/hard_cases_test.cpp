// Cases in which geometry degenerates: what must happen, by paper.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <limits>

#include "plugins/shadow_planes/worlds.h"

namespace moire::test {
namespace {

using namespace shadow_planes;

// A floor of 6 x 6 in z = 0 under a point light, black sky.
World floor_world(const Vector& light, std::vector<std::vector<Vector>> others = {}) {
  World world;
  world.faces.push_back(face_of(std::vector<Vector>{{-3, -3, 0}, {3, -3, 0}, {3, 3, 0}, {-3, 3, 0}}));
  for (const auto& corners : others) world.faces.push_back(face_of(corners));
  world.light.kind = LightKind::point;
  world.light.place = light;
  return world;
}

// Straight down from far: the image's point (50 + 10 x, 50 - 10 y) sees (x, y, 0).
Camera above() {
  Camera camera;
  camera.size = {100, 100};
  camera.eye = {0, 0, 100};
  camera.down = {0, -1, 0};
  camera.focal = 1000;
  return camera;
}

Element element_at(const World& world, double x, double y, const Camera& camera = above()) {
  return hit_at(*frame_of(world, camera, {Shade::flat, Clip::both}), {50 + 10 * x, 50 - 10 * y}).element;
}

struct Collector : PolygonSink {
  std::vector<Element> elements;
  bool all_finite = true;
  void polygon(const Polygon& polygon) override {
    elements.push_back(polygon.element);
    for (const Point& p : polygon.points) all_finite = all_finite && std::isfinite(p.x) && std::isfinite(p.y);
  }
};

Collector polygons_of(const World& world, const Camera& camera = above()) {
  Collector collector;
  frame_of(world, camera, {Shade::flat, Clip::both})->polygons()->stream({0, 0, 100, 100}, collector);
  return collector;
}

constexpr Element floor_lit = lit(0), floor_shadowed = shadowed(0, 1), floor_unlit = unlit(0);

}  // namespace

TEST_CASE("a receiver with the light in its plane, or facing away from it, is unlit and takes no shadow") {
  const std::vector<Vector> board{{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};
  for (const Vector& light : {Vector{5, 0, 0}, Vector{0.5, 0.5, 0}, Vector{0, 0, -2}, Vector{5, 0, 1e-13}}) {
    const World world = floor_world(light, {board});
    CHECK(element_at(world, 2, 2) == floor_unlit);
    const auto polygons = polygons_of(world);
    CHECK(std::count(polygons.elements.begin(), polygons.elements.end(), floor_unlit) == 1);
    CHECK(std::count(polygons.elements.begin(), polygons.elements.end(), floor_shadowed) == 0);
  }
  // From below, the side that the light does not reach is seen.
  Camera below = above();
  below.eye = {0, 0, -100};
  below.ahead = {0, 0, 1};
  CHECK(element_at(floor_world({0, 0, 2}), 1, 1, below) == floor_unlit);
  CHECK(element_at(floor_world({0, 0, -2}), 1, 1, below) == floor_lit);
}

TEST_CASE("an occluder that stands on the receiver, or passes through it, shadows it from its foot on") {
  for (const double bottom : {0.0, -1.0}) {
    const World world = floor_world({2, 0, 2}, {{{0, -1, bottom}, {0, 1, bottom}, {0, 1, 1}, {0, -1, 1}}});
    // The top's shadow ends at x = -2, where it is twice as wide.
    for (const double x : {-1e-6, -0.5, -1.99}) CHECK(element_at(world, x, 0) == floor_shadowed);
    for (const double x : {1e-6, 0.5, -2.01}) CHECK(element_at(world, x, 0) == floor_lit);
    CHECK(element_at(world, -1.9, 1.9) == floor_shadowed);
    CHECK(element_at(world, -0.1, 1.1) == floor_lit);
    CHECK(element_at(world, -1.9, -1.9) == floor_shadowed);
  }
}

TEST_CASE("points exactly in an upright occluder's plane are lit") {
  const World world = floor_world({0, 2, 3}, {{{0, -1, 0}, {0, 1, 0}, {0, 1, 1}, {0, -1, 1}}});
  // The light is in that plane as well: the wall's shadow has no width.
  for (const double x : {0.0, -1e-3, 1e-3}) CHECK(element_at(world, x, -1.5) == floor_lit);
  const World aside = floor_world({1, 0, 3}, {{{0, -1, 0}, {0, 1, 0}, {0, 1, 1}, {0, -1, 1}}});
  for (const double y : {-0.9, 0.0, 0.3})
    CHECK(hit_at(*frame_of(aside, above(), {Shade::flat, Clip::both}), {50, 50 - 10 * y}).element != floor_shadowed);
}

TEST_CASE("of occluders that reach beyond the light's height, what is below it casts shadow") {
  // It rises from (1, 0) at z = 1 to x = 3 at z = 3; the light over the origin at z = 2. Above x = 2 it hides nothing.
  const World world = floor_world({0, 0, 2}, {{{1, -1, 1}, {3, -1, 3}, {3, 1, 3}, {1, 1, 1}}});
  CHECK(element_at(world, -2.5, 0) == floor_lit);  // where the part above would project to
  Camera camera = above();
  camera.eye = {0, 0, 0.5};  // below the board
  camera.focal = 5;
  const auto frame = frame_of(world, camera, {Shade::flat, Clip::both});
  // The near edge's shadow is at x = 2; all beyond is in shadow.
  CHECK(hit_at(*frame, {50 + 10 * 1.9, 50}).element == floor_lit);
  CHECK(hit_at(*frame, {50 + 10 * 2.1, 50}).element == floor_shadowed);
  CHECK(hit_at(*frame, {50 + 10 * 2.9, 50}).element == floor_shadowed);
  const auto published = frame_of(world, camera, {Shade::flat, Clip::none});
  CHECK(hit_at(*published, {50 + 10 * 2.9, 50}).element != hit_at(*frame, {50 + 10 * 2.9, 50}).element);
}

TEST_CASE("polygons without area and needles hide nothing and break nothing") {
  const World world = floor_world({0, 0, 3}, {{{0, 0, 1}, {0, 0, 1}, {1, 1, 1}},
                                              {{0.5, 0.5, 1}, {1.5, 1.5, 1}, {1, 1 + 1e-13, 1}},
                                              {{1, 0, 1}, {1, 0, 2}, {1, 0, 1.5}}});
  CHECK(element_at(world, 0.9, 0.8) == floor_lit);
  CHECK(element_at(world, 1.5, 0) == floor_lit);
  CHECK(polygons_of(world).all_finite);
}

TEST_CASE("a light on an occluder, at its corner or in its plane, gives finite pictures") {
  const std::vector<Vector> board{{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}};
  for (const Vector& light : {Vector{0, 0, 2}, Vector{1, 1, 2}, Vector{1, 0, 2}, Vector{7, 0, 2}}) {
    const World world = floor_world(light, {board});
    CHECK(element_at(world, 2, 2) == floor_lit);
    const auto polygons = polygons_of(world);
    CHECK(polygons.all_finite);
    CHECK(std::count(polygons.elements.begin(), polygons.elements.end(), floor_shadowed) == 0);
  }
}

TEST_CASE("an occluder in an area light's plane hides its share of the light, as just below it") {
  const auto irradiance = [](double z) {
    World world = floor_world({}, {{{0.1, -2, z}, {2, -2, z}, {2, 2, z}, {0.1, 2, z}}});
    world.faces[1].receives = false;
    const Face light = face_of(std::vector<Vector>{{-0.5, -0.5, 4}, {-0.5, 0.5, 4}, {0.5, 0.5, 4}, {0.5, -0.5, 4}});
    world.light = {LightKind::area, {}, light.plane, light.parts};
    const auto frame = frame_of(world, above(), {Shade::flat, Clip::both});
    IrradianceMap map{1, 1, {0}};
    std::vector<LightPoint> lights;
    for (int k = 0; k < 1000; ++k) lights.push_back({0.5F, (static_cast<float>(k) + 0.5F) / 1000});
    frame->receivers()->add_hard_shadows(0, lights, ShadowEdges::by_middle, map);
    int seen_lit = 0;
    for (const LightPoint& p : lights) seen_lit += hit_at(*frame, {50 - 20, 50, p.u, p.v}).element == lit(0) ? 1 : 0;
    return std::pair{static_cast<double>(map.cells[0]), seen_lit / 1000.0};
  };
  // Of the light from x = -.5 to .5, .6 is free.
  for (const double z : {4.0, 4 - 1e-9}) {
    CHECK(std::abs(irradiance(z).first - 0.6) <= 1.1e-3);
    CHECK(std::abs(irradiance(z).second - 0.6) <= 1.1e-3);
  }
  // A thousand floats are added.
  CHECK(std::abs(irradiance(4 + 1e-6).first - 1) <= 1000 * 0x1p-24);
}

TEST_CASE("a light that faces away lights nothing") {
  World world = floor_world({});
  const Face light = face_of(std::vector<Vector>{{-0.5, -0.5, 4}, {0.5, -0.5, 4}, {0.5, 0.5, 4}, {-0.5, 0.5, 4}});
  world.light = {LightKind::area, {}, light.plane, light.parts};
  for (const Shade shade : {Shade::diffuse, Shade::flat}) {
    const auto frame = frame_of(world, above(), {shade, Clip::both});
    CHECK(hit_at(*frame, {50, 50, 0.2F, 0.7F}).element == floor_unlit);
    IrradianceMap map{4, 4, std::vector<float>(16)};
    const LightPoint p{0.2F, 0.7F};
    if (frame->receivers()->count() > 0) frame->receivers()->add_hard_shadows(0, {&p, 1}, ShadowEdges::by_area, map);
    CHECK(map.cells == std::vector<float>(16));
  }
}

TEST_CASE("a world without faces shows the sky") {
  World world;
  for (const LightKind kind : {LightKind::point, LightKind::directional}) {
    world.light.kind = kind;
    const auto frame = frame_of(world, above(), {Shade::flat, Clip::both});
    CHECK(hit_at(*frame, {3, 4}).element == background);
    CHECK(hit_at(*frame, {3, 4}).color == world.sky);
    CHECK(polygons_of(world).elements.empty());
  }
}

TEST_CASE("coplanar copies of an occluder and tiles of one change no point's light") {
  const std::vector<Vector> board{{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};
  const World one = floor_world({0.3, 0.2, 3}, {board});
  const World two = floor_world({0.3, 0.2, 3}, {board, board});
  const World tiles = floor_world({0.3, 0.2, 3}, {{{-1, -1, 1}, {0, -1, 1}, {0, 1, 1}, {-1, 1, 1}},
                                                  {{0, -1, 1}, {1, -1, 1}, {1, 1, 1}, {0, 1, 1}}});
  // From below the boards; the tiles' common edge throws its shadow on x = -.15, which is looked at as well.
  Camera camera = above();
  camera.eye = {0, 0, 0.5};
  camera.focal = 5;
  for (double x = -2.95; x < 3; x += 0.1) {
    for (double y = -2.95; y < 3; y += 0.1) {
      const bool is_lit = element_at(one, x, y, camera) == floor_lit;
      CHECK(element_at(two, x, y, camera) == (is_lit ? floor_lit : floor_shadowed));
      CHECK((element_at(tiles, x, y, camera) == floor_lit) == is_lit);
    }
  }
}

TEST_CASE("faces that cast or receive no shadows do not") {
  const std::vector<Vector> board{{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};
  World world = floor_world({3, 0, 3}, {board});
  CHECK(element_at(world, -1.5, 0) == floor_shadowed);
  world.faces[1].casts = false;
  CHECK(element_at(world, -1.5, 0) == floor_lit);
  world.faces[1].casts = true;
  world.faces[0].receives = false;
  CHECK(element_at(world, -1.5, 0) == floor_lit);
}

}  // namespace moire::test
