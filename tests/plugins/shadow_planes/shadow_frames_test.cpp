// Whole pictures, held to rays: what points see, what polygons cover, what parts of windows show.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <map>

#include <moire/receivers.h>

#include "plugins/shadow_planes/brute_force.h"
#include "plugins/shadow_planes/worlds.h"
#include "sanitized.h"
#include "seeing/visible_parts.h"

namespace moire::test {
namespace {

using namespace shadow_planes;

constexpr ImageSize size{120, 90};

double difference(const Color& p, const Color& q) {
  return static_cast<double>(std::max({std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)}));
}

// From the outside, from within the room, and straight down.
std::vector<Camera> cameras() {
  std::vector<Camera> all;
  for (const Changes& view :
       {Changes{},
        Changes{{"view.aim", std::string("angles")},
                {"view.x", 0.31},
                {"view.y", 0.27},
                {"view.z", 0.7},
                {"view.yaw_deg", -40.0},
                {"view.pitch_deg", -20.0},
                {"view.roll_deg", 13.0},
                {"view.fov_deg", 110.0}},
        Changes{{"view.x", 0.1}, {"view.y", 0.2}, {"view.z", 6.0}, {"view.target_x", 0.1}, {"view.target_y", 0.2}},
        Changes{{"view.x", 4.0}, {"view.y", -2.0}, {"view.z", -1.0}}})
    all.push_back(camera_of(shadow_settings(view), size));
  return all;
}

struct First : PolygonSink {
  Point p;
  std::optional<Hit> hit;
  void polygon(const Polygon& polygon) override {
    if (hit) return;
    int winding = 0;
    const std::size_t n = polygon.points.size();
    for (std::size_t k = 0; k < n; ++k) {
      const Point &a = polygon.points[k], &b = polygon.points[(k + 1) % n];
      if ((a.y <= p.y) == (b.y <= p.y)) continue;
      const bool is_left = (b.x - a.x) * (p.y - a.y) - (p.x - a.x) * (b.y - a.y) > 0;
      if (is_left == (b.y > a.y)) winding += b.y > a.y ? 1 : -1;
    }
    if (winding != 0) hit = Hit{polygon.element, polygon.color};
  }
};

Hit first_polygon(const Frame& frame, Point p) {
  First first;
  first.p = p;
  frame.polygons()->stream({p.x - 0.5, p.y - 0.5, p.x + 0.5, p.y + 0.5}, first);
  return first.hit.value_or(Hit{background, frame.polygons()->background_color()});
}

// Twenty triangles through each other, on a floor.
World tangle(const Settings& settings) {
  World world = built_in_world(settings);
  world.faces.resize(1);
  Randoms random(11);
  for (int k = 0; k < 20; ++k) {
    const Vector p = random.vector(-1.5, 1.5) + Vector{0, 0, 1.2};
    world.faces.push_back(face_of(std::vector<Vector>{p, p + random.vector(-1, 1), p + random.vector(-1, 1)}));
  }
  share_planes(world.faces);
  return world;
}

World world_of(const std::string& kind, Changes changes = {}) {
  changes.emplace_back("kind", kind == "tangle" ? std::string("tilted") : kind);
  const Settings settings = shadow_settings(changes);
  return kind == "tangle" ? tangle(settings) : built_in_world(settings);
}

constexpr std::array all_kinds{"tangle", "room", "tilted", "parallel", "three", "wall", "slats"};
constexpr int points_each = sanitized ? 60 : 3000;

}  // namespace

TEST_CASE("points of shadow_planes see what rays see, in every world, under every light") {
  Randoms random(3);
  int lit_ones = 0, shadowed_ones = 0, unlit_ones = 0;
  for (const char* kind : all_kinds) {
    for (const char* light : {"area", "point", "directional"}) {
      for (const char* shading : {"diffuse", "flat"}) {
        const World world = world_of(kind, {{"light.kind", std::string(light)}});
        const Look look{std::string(shading) == "flat" ? Shade::flat : Shade::diffuse, Clip::both};
        const LightPoints lights(world.light);
        for (const Camera& camera : cameras()) {
          const auto frame = frame_of(world, camera, look);
          for (int k = 0; k < points_each / 10; ++k) {
            const SamplePoint p{random(-3, size.width + 3), random(-3, size.height + 3),
                                static_cast<float>(random(0, 0.999)), static_cast<float>(random(0, 0.999))};
            const Hit hit = hit_at(*frame, p);
            const Homogeneous there = lights.at(static_cast<double>(p.u), static_cast<double>(p.v));
            const Hit expected = seen(world, camera, look.shade, there, {p.x, p.y});
            if (hit.element != expected.element || difference(hit.color, expected.color) > 1e-6) {
              CAPTURE(kind, light, shading, p.x, p.y, p.u, p.v);
              CHECK(hit.element == expected.element);
              CHECK(difference(hit.color, expected.color) <= 1e-6);
            }
            const auto low = static_cast<std::uint32_t>(hit.element);
            ++(low == 0 ? lit_ones : low == 0xffffffffU ? unlit_ones : shadowed_ones);
          }
        }
      }
    }
  }
  // None of them was missing from the test.
  CHECK(std::min({lit_ones, shadowed_ones, unlit_ones}) > 20);
}

TEST_CASE("the first polygon at a point is what the point sees, with clipped and with published shadows") {
  Randoms random(4);
  for (const char* kind : all_kinds) {
    for (const char* light : {"point", "directional"}) {
      for (const Clip clip : {Clip::both, Clip::none}) {
        // At a height that no corner has: as published, shadows of such corners are as far as rounding takes them.
        const World world = world_of(kind, {{"light.kind", std::string(light)}, {"light.z", -2.137}});
        for (const Camera& camera : cameras()) {
          const auto frame = frame_of(world, camera, {Shade::flat, clip});
          int wrong = 0;
          for (int k = 0; k < points_each; ++k) {
            const Point p{random(-3, size.width + 3), random(-3, size.height + 3)};
            const Hit hit = hit_at(*frame, {p.x, p.y});
            const Hit first = first_polygon(*frame, p);
            wrong += first.element != hit.element || !(first.color == hit.color) ? 1 : 0;
          }
          CAPTURE(kind, light, clip == Clip::both);
          CHECK(wrong == 0);
        }
      }
    }
  }
}

// A straight edge crosses 2 n of a pixel's n x n cells at most, each wrong by half a cell at most: 1 / n an edge, and
// pixels of more than three edges' contrast are rare enough to have none here.
TEST_CASE("exact areas of hard shadows are what many points find, the same bits in blocks of any width") {
  constexpr int n = 32;
  for (const char* light : {"point", "directional"}) {
    const World world = world_of("room", {{"light.kind", std::string(light)}});
    const Camera camera = camera_of(shadow_settings(), {45, 38});
    const auto frame = frame_of(world, camera, {Shade::flat, Clip::both});
    const auto exact = sampler("area", {{"method", std::string("exact")}});
    const Rendered image = rendered(*exact, *frame);
    CHECK(first_difference(image, rendered(*exact, *frame, nullptr, {.threads = 2, .block_width = 7})) == "");
    const auto points = sampler("supersample", {{"n", std::int64_t{n}}, {"layout", std::string("grid")}});
    const Rendered many = rendered(*points, *frame, nullptr, {.recording = false});
    double worst = 0;
    for (std::size_t k = 0; k < image.pixels.size(); ++k) {
      worst = std::max(worst, difference(image.pixels[k].color, many.pixels[k].color));
    }
    CHECK(worst <= 3.0 / n);
  }
}

TEST_CASE("visible parts fill every window once, and show what rays see first") {
  Randoms random(5);
  for (const char* kind : all_kinds) {
    const World world = world_of(kind);
    for (const Camera& camera : cameras()) {
      const VisibleParts visible(world, camera);
      std::vector<Part> parts;
      for (int k = 0; k < (sanitized ? 20 : 400); ++k) {
        const double x = std::floor(random(-2, size.width + 2)), y = std::floor(random(-2, size.height + 2));
        const double side = k % 2 == 0 ? 1 : 9.5;
        visible.in({x, y, x + side, y + side}, parts);
        double area = 0;
        for (const Part& part : parts) {
          const double doubled = doubled_area(part.outline);
          CHECK(doubled > 0);
          area += doubled / 2;
        }
        CHECK(std::abs(area - side * side) <= 1e-12 * side * side);
        const Point p{x + random(0, side), y + random(0, side)};
        const auto first = first_face(world, camera, p);
        int holders = 0;
        for (const Part& part : parts) {
          const Point* from = &part.outline.back();
          bool holds = true;
          for (const Point& to : part.outline) {
            holds = holds && edge_line(*from, to)(p) > 0;
            from = &to;
          }
          holders += holds ? 1 : 0;
          if (holds) CHECK(part.face == (first ? first->face : Part::none));
        }
        CHECK(holders == 1);
      }
    }
  }
}

TEST_CASE("faces that pass through each other, lie in one plane or are seen edge-on are seen as rays see them") {
  World world;
  const auto add = [&](const std::vector<Vector>& corners) { world.faces.push_back(face_of(corners)); };
  add({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
  add({{-1, 0.2, -1}, {1, 0.2, -1}, {1, 0.2, 1}, {-1, 0.2, 1}});   // through the first
  add({{0, -1, -1}, {0, 1, -1}, {0.3, 1, 1}, {0.3, -1, 1}});       // through both
  add({{-0.5, -0.5, 0}, {0.7, -0.5, 0}, {0.7, 0.5, 0}});           // in the plane of the first, behind it in the list
  add({{0, 0, 0.5}, {0, 0, 0.5}, {1, 1, 0.5}});                    // without area
  add({{0.5, 0.5, 0.3}, {1, 1, 0.3}, {0.75, 0.75 + 1e-13, 0.3}});  // a needle
  share_planes(world.faces);
  world.light.kind = LightKind::point;
  world.light.place = {0.3, -0.4, 3};
  Randoms random(6);
  for (int view = 0; view < 20; ++view) {
    const Vector eye = view == 0 ? Vector{-3, 0.1, 0} : random.vector(-3, 3);
    const Camera camera = camera_of(
        shadow_settings({{"view.x", eye.x}, {"view.y", eye.y}, {"view.z", eye.z}, {"view.target_z", 0.0}}), size);
    const auto frame = frame_of(world, camera, {Shade::flat, Clip::both});
    int wrong_points = 0, wrong_polygons = 0;
    for (int k = 0; k < points_each; ++k) {
      const Point p{random(0, size.width), random(0, size.height)};
      const Hit hit = hit_at(*frame, {p.x, p.y});
      wrong_points += hit.element != seen(world, camera, Shade::flat, {0.3, -0.4, 3, 1}, p).element ? 1 : 0;
      wrong_polygons += hit.element != first_polygon(*frame, p).element ? 1 : 0;
    }
    CAPTURE(view);
    CHECK(wrong_points == 0);
    CHECK(wrong_polygons == 0);
  }
}

}  // namespace moire::test
