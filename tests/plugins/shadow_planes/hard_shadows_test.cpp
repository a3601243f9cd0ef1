// Hard shadows as polygons, held to rays: with clipping no point may be wrong; without, as published, most scenes whose
// occluders reach behind the receiver or beyond the light must be, or the test sees nothing.
#include <catch2/catch_test_macros.hpp>
#include <string>

#include "hard/clip_to.h"
#include "hard/shadow.h"
#include "plugins/shadow_planes/brute_force.h"
#include "sanitized.h"

namespace moire::test {
namespace {

using namespace shadow_planes;

// Where the corners of the occluder are.
enum class Corners { between, some_behind, some_beyond, both, all_behind, all_beyond };

struct Scene {
  Plane receiver;
  Vector origin, u, v;  // a point of the receiver and two directions in it, of length 1 and at right angles
  Homogeneous light;
  Convex occluder;

  Vector at(const Point& p) const { return origin + p.x * u + p.y * v; }
};

Vector normalized(const Vector& p) { return (1 / length(p)) * p; }

// Any plane; a light 1 to 3 above it; a triangle within reach of the light's foot.
Scene random_scene(Randoms& random, Corners corners, bool is_directional) {
  Scene scene;
  const Vector normal = normalized(random.vector(-1, 1) + Vector{1e-9, 0, 0});
  scene.origin = random.vector(-2, 2);
  scene.receiver = {normal, -dot(normal, scene.origin)};
  scene.u = normalized(cross(normal, random.vector(-1, 1)));
  scene.v = cross(normal, scene.u);
  const double height = random(1, 3);
  const Vector foot = scene.at({random(-1, 1), random(-1, 1)});
  const Vector place = foot + height * normal;
  if (is_directional) {
    const Vector way = normalized(place - scene.origin);
    scene.light = {way.x, way.y, way.z, 0};
  } else {
    scene.light = {place.x, place.y, place.z, 1};
  }
  const auto corner = [&](double low, double high) {
    scene.occluder.push_back(scene.at({random(-2, 2), random(-2, 2)}) + random(low, high) * normal);
  };
  const auto between = [&] { corner(0, height); };
  const auto behind = [&] { corner(-height, 0); };
  const auto beyond = [&] { corner(height, 2 * height); };
  const bool two = random(0, 1) < 0.5;
  switch (corners) {
    case Corners::between:
      between(), between(), between();
      break;
    case Corners::some_behind:
      behind(), between(), two ? behind() : between();
      break;
    case Corners::some_beyond:
      beyond(), between(), two ? beyond() : between();
      break;
    case Corners::both:
      behind(), beyond(), between();
      break;
    case Corners::all_behind:
      behind(), behind(), behind();
      break;
    case Corners::all_beyond:
      beyond(), beyond(), beyond();
      break;
  }
  return scene;
}

bool contains(const Outline& polygon, const Point& p) {
  int winding = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    const bool is_left = (b.x - a.x) * (p.y - a.y) - (p.x - a.x) * (b.y - a.y) > 0;
    if (is_left == (b.y > a.y)) winding += b.y > a.y ? 1 : -1;
  }
  return winding != 0;
}

struct Counts {
  int scenes = 0, with_false = 0, with_missing = 0;
  double false_percent() const { return 100.0 * with_false / scenes; }
  double missing_percent() const { return 100.0 * with_missing / scenes; }
};

// 200 points each of a receiver of 6 x 6.
Counts compared(Clip clip, Corners corners, bool is_directional, int scenes, std::uint64_t seed) {
  Counts counts;
  counts.scenes = scenes;
  Randoms random(seed);
  ShadowProjector project(clip);
  ClipTo clip_to;
  const Outline edges{{-3, -3}, {3, -3}, {3, 3}, {-3, 3}};
  std::vector<Pole> shadow;
  for (int k = 0; k < scenes; ++k) {
    const Scene scene = random_scene(random, corners, is_directional);
    shadow.clear();
    for (const Homogeneous& s : project(scene.occluder, scene.receiver, scene.light)) {
      const Vector from_origin = Vector{s.x, s.y, s.z} - s.w * scene.origin;
      shadow.push_back({dot(scene.u, from_origin), dot(scene.v, from_origin), s.w});
    }
    const Outline& polygon = clip_to(shadow, edges);
    bool any_false = false, any_missing = false;
    for (int i = 0; i < 200; ++i) {
      const double x = random(-3, 3), y = random(-3, 3);
      const bool drawn = contains(polygon, {x, y});
      const bool hidden = stands_between(scene.occluder, scene.at({x, y}), scene.light);
      any_false = any_false || (drawn && !hidden);
      any_missing = any_missing || (!drawn && hidden);
    }
    counts.with_false += any_false ? 1 : 0;
    counts.with_missing += any_missing ? 1 : 0;
  }
  return counts;
}

}  // namespace

TEST_CASE("clipped hard shadows of point and directional lights agree with rays at eight million points") {
  constexpr int scenes = sanitized ? 100 : 4000;
  for (const bool is_directional : {false, true}) {
    for (const Corners corners : {Corners::between, Corners::some_behind, Corners::some_beyond, Corners::both,
                                  Corners::all_behind, Corners::all_beyond}) {
      if (is_directional && corners == Corners::all_beyond) continue;  // a plane at infinity has no beyond
      CAPTURE(is_directional, static_cast<int>(corners));
      // Five and six cases: 20,000 scenes and more of each kind of light, 200 points each.
      const Counts counts = compared(Clip::both, corners, is_directional, scenes, 1);
      CHECK(counts.with_false == 0);
      CHECK(counts.with_missing == 0);
    }
  }
}

// Percentages of scenes with such a point, at least. Other triangles than these gave 52, 90 and 69, 65 and 96, 35, 56
// and, directional, 66 and 76: the larger they are and the nearer to the receiver's middle, the more of the receiver
// they wrongly cover. Which of the cases never fail does not depend on that.
TEST_CASE("hard shadows as published are false in most scenes with occluders behind the receiver or beyond the light") {
  struct Case {
    Corners corners;
    bool is_directional;
    double false_percent, missing_percent;
  };
  for (const Case& c : {Case{Corners::between, false, 0, 0}, Case{Corners::some_behind, false, 50, 0},
                        Case{Corners::some_beyond, false, 85, 55}, Case{Corners::both, false, 65, 90},
                        Case{Corners::all_behind, false, 35, 0}, Case{Corners::all_beyond, false, 55, 0},
                        Case{Corners::between, true, 0, 0}, Case{Corners::some_behind, true, 60, 0},
                        Case{Corners::all_behind, true, 70, 0}}) {
    CAPTURE(static_cast<int>(c.corners), c.is_directional);
    const Counts counts = compared(Clip::none, c.corners, c.is_directional, sanitized ? 100 : 1000, 2);
    CAPTURE(counts.false_percent(), counts.missing_percent());
    CHECK((c.false_percent > 0 ? counts.false_percent() > c.false_percent : counts.with_false == 0));
    CHECK((c.missing_percent > 0 ? counts.missing_percent() > c.missing_percent : counts.with_missing == 0));
  }
}

}  // namespace moire::test
