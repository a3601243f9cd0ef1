// (u, v) of area lights: equal areas for equal areas.
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "plugins/shadow_planes/brute_force.h"
#include "world/cut.h"
#include "world/faces.h"
#include "world/light_points.h"

namespace moire::test {
namespace {

using namespace shadow_planes;

Light light_from(const std::vector<Vector>& corners) {
  const Face face = face_of(corners);
  Light light;
  light.plane = face.plane;
  light.parts = face.parts;
  return light;
}

double area_of(const Convex& part) {
  double area = 0;
  for (std::size_t k = 2; k < part.size(); ++k) area += length(cross(part[k - 1] - part[0], part[k] - part[0])) / 2;
  return area;
}

}  // namespace

// Of a grid of n x n cells of (u, v), those that a cut of the light crosses lie along a curve that is monotone in
// pieces: 4 n of them at most for each of up to 6 pieces, each wrong by half a cell at most, of either sign. Their
// sum's standard deviation is below sqrt(24 n) / 2 cells, .0009 of all; 1 / n is five times as much.
TEST_CASE("the share of (u, v) on one side of any cut through a light is the share of its area") {
  constexpr int n = 200;
  Randoms random(1);
  const std::vector<std::vector<Vector>> lights{
      {{0, 0, 1}, {2, 0.5, 1}, {2.5, 2, 1}, {0.5, 1.5, 1}},                                       // a parallelogram
      {{0, 0, 1}, {1, 0, 2}, {0, 1, 0}},                                                          // a triangle
      {{0, 0, 1}, {2, -0.5, 1}, {3, 1, 1}, {1.5, 2.5, 1}, {0, 2, 1}},                             // a pentagon
      {{0, 0, 1}, {4, 0, 1}, {4, 1, 1}, {3, 1, 1}, {3, 3, 1}, {2, 3, 1}, {2, 1, 1}, {0, 1, 1}}};  // concave
  for (std::size_t k = 0; k < lights.size(); ++k) {
    const Light light = light_from(lights[k]);
    const LightPoints points(light);
    double area = 0;
    std::size_t pieces = 0;
    for (const Convex& part : light.parts) area += area_of(part), pieces += part.size() - 2;
    CHECK(std::abs(points.area() - area) <= 1e-15 * 10 * area);
    for (int cut = 0; cut < 10; ++cut) {
      const Vector normal = random.vector(-1, 1);
      const Homogeneous through = points.at(random(0.2, 0.8), random(0.2, 0.8));
      const Plane plane{normal, -dot(normal, {through.x, through.y, through.z})};
      double expected = 0;
      Convex inside;
      for (const Convex& part : light.parts) {
        keep(
            part, [&](const Vector& p) { return plane.distance(p); }, inside);
        expected += area_of(inside) / area;
      }
      double share = 0;
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          const Homogeneous p = points.at((i + 0.5) / n, (j + 0.5) / n);
          CHECK(p.w == 1);
          share += plane.of(p) > 0 ? 1.0 / (n * n) : 0;
        }
      }
      CAPTURE(k, cut);
      CHECK(std::abs(share - expected) <= 1.0 / n);
    }
  }
}

TEST_CASE("u goes along the first side of a parallelogram and v along its last, evenly") {
  const LightPoints points(light_from({{1, 2, 3}, {3, 2, 3}, {3, 5, 3}, {1, 5, 3}}));
  const Homogeneous p = points.at(0.25, 0.5);
  CHECK((p.x == 1.5 && p.y == 3.5 && p.z == 3 && p.w == 1));
  CHECK(points.area() == 6);
}

TEST_CASE("a point light is where it is and a directional one is a direction, for every (u, v)") {
  Light light;
  light.kind = LightKind::point;
  light.place = {1, 2, 3};
  const Homogeneous p = LightPoints(light).at(0.3, 0.9);
  CHECK((p.x == 1 && p.y == 2 && p.z == 3 && p.w == 1));
  light.kind = LightKind::directional;
  CHECK(LightPoints(light).at(0.3, 0.9).w == 0);
}

}  // namespace moire::test
