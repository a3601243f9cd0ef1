// Polygons as faces: planes, convex parts of concave ones, and what is refused.
#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>

#include "plugins/shadow_planes/brute_force.h"
#include "seeing/outline.h"
#include "world/convex_parts.h"
#include "world/faces.h"
#include "world/kinds.h"

namespace moire::test {
namespace {

using namespace shadow_planes;

double area_of(const std::vector<Point>& polygon) {
  double doubled = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    doubled += a.x * b.y - a.y * b.x;
  }
  return doubled / 2;
}

// Its corners go round a middle, at any distance from it.
std::vector<Point> random_star(Randoms& random, int corners) {
  std::vector<Point> polygon;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * (k + random(0.05, 0.95)) / corners, far = random(0.1, 2);
    polygon.push_back({far * std::cos(angle), far * std::sin(angle)});
  }
  return polygon;
}

std::vector<Point> spiral(int turns) {
  std::vector<Point> polygon;
  for (int k = 0; k <= 8 * turns; ++k)
    polygon.push_back({(1.0 + k) * std::cos(k * std::numbers::pi / 4), (1.0 + k) * std::sin(k * std::numbers::pi / 4)});
  for (int k = 8 * turns; k >= 0; --k)
    polygon.push_back({(0.2 + k) * std::cos(k * std::numbers::pi / 4), (0.2 + k) * std::sin(k * std::numbers::pi / 4)});
  return polygon;
}

void check_parts(const std::vector<Point>& polygon) {
  const auto parts = convex_parts(polygon);
  double area = 0;
  for (const auto& part : parts) {
    std::vector<Point> corners;
    for (const std::size_t k : part) corners.push_back(polygon[k]);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Point &a = corners[k], &b = corners[(k + 1) % corners.size()], &c = corners[(k + 2) % corners.size()];
      CHECK((b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x) >= 0);
    }
    CHECK(area_of(corners) > 0);
    area += area_of(corners);
  }
  // Parts whose areas sum to the whole's and whose corners are the polygon's can neither overlap nor leave it, unless
  // one of them leaves it by as much as two overlap: points tell.
  CHECK(std::abs(area - area_of(polygon)) <= 1e-12 * area);
  Randoms random(9);
  for (int i = 0; i < 50; ++i) {
    const double reach = std::sqrt(area) + 1;
    const Point p{random(-reach, reach), random(-reach, reach)};
    const auto winds = [&](const auto& corner, std::size_t count) {
      bool inside = false;
      for (std::size_t k = 0; k < count; ++k) {
        const Point a = corner(k), b = corner((k + 1) % count);
        if ((a.y <= p.y) != (b.y <= p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
      }
      return inside;
    };
    int holders = 0;
    for (const auto& part : parts)
      holders += winds([&](std::size_t k) { return polygon[part[k]]; }, part.size()) ? 1 : 0;
    CHECK(holders == (winds([&](std::size_t k) { return polygon[k]; }, polygon.size()) ? 1 : 0));
  }
}

}  // namespace

TEST_CASE("concave polygons fall into convex parts that cover them once") {
  Randoms random(1);
  for (int k = 0; k < 300; ++k) check_parts(random_star(random, 4 + k % 20));
  check_parts(spiral(3));
  check_parts({{0, 0}, {4, 0}, {4, 1}, {3, 1}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
  // A corner on another side.
  check_parts({{0, 0}, {4, 0}, {4, 4}, {2, 0.25}, {0, 4}});
}

TEST_CASE("a convex polygon stays whole, and corners between sides of one line are left out") {
  CHECK(convex_parts(std::vector<Point>{{0, 0}, {2, 0}, {2, 1}, {0, 1}}).size() == 1);
  const auto parts = convex_parts(std::vector<Point>{{0, 0}, {1, 0}, {2, 0}, {2, 0}, {2, 1}, {0, 1}, {0, 0.5}});
  REQUIRE(parts.size() == 1);
  CHECK(parts[0].size() == 4);
}

TEST_CASE("a face's normal points to where its corners go round counterclockwise, whatever its plane") {
  Randoms random(2);
  for (int k = 0; k < 200; ++k) {
    const Vector along = random.vector(-1, 1), other = random.vector(-1, 1), origin = random.vector(-5, 5);
    std::vector<Vector> corners;
    for (const Point& p : random_star(random, 7)) corners.push_back(origin + p.x * along + p.y * other);
    REQUIRE(problem_of(corners).empty());
    const Face face = face_of(corners);
    CHECK(dot(face.plane.normal, cross(along, other)) > 0);
    CHECK(std::abs(length(face.plane.normal) - 1) <= 1e-15);
    for (const Vector& p : corners) CHECK(std::abs(face.plane.distance(p)) <= 1e-14 * 10);
    for (const Convex& part : face.parts) {
      for (std::size_t i = 0; i < part.size(); ++i) {
        const Vector turn =
            cross(part[(i + 1) % part.size()] - part[i], part[(i + 2) % part.size()] - part[(i + 1) % part.size()]);
        CHECK(dot(turn, face.plane.normal) >= -1e-13);
      }
    }
  }
}

TEST_CASE("corners that make no face are refused, with what was found") {
  using Corners = std::vector<Vector>;
  CHECK(problem_of(Corners{{0, 0, 0}, {1, 0, 0}}) == "is no polygon (2 corners); 3 or more make one");
  CHECK(problem_of(Corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5}, {0, 1, 0}}) ==
        "is not flat (a corner is 0.118 off its plane); 1.5e-09 at most is");
  CHECK(problem_of(Corners{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1.5, 1.8, 0}}) ==
        "crosses itself (sides from corners 1 and 3); a simple polygon does not");
  CHECK(problem_of(Corners{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}) ==
        "crosses itself (its areas cancel); a simple polygon goes round once");
  // Without area: no face to see, and none to refuse.
  for (const Corners& corners : {Corners{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, Corners{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}},
                                 Corners{{0, 0, 0}, {1, 2, 3}, {1, 2, 3}, {0, 0, 0}}}) {
    CHECK(problem_of(corners).empty());
    CHECK(face_of(corners).parts.empty());
  }
}

TEST_CASE("faces in one plane share it to the bit, whichever way they look") {
  const Vector a{0.1, 0.2, 0.3}, u{1, 0.37, -0.21}, v{-0.4, 1.3, 0.77};
  std::vector<Face> faces;
  Randoms random(3);
  for (int k = 0; k < 20; ++k) {
    const Vector p = a + random(-3, 3) * u + random(-3, 3) * v;
    std::vector<Vector> corners{p, p + u, p + u + v, p + v};
    if (k % 2 == 1) std::reverse(corners.begin(), corners.end());
    faces.push_back(face_of(corners));
  }
  faces.push_back(face_of(std::vector<Vector>{a, a + u, a + u + v + Vector{0, 0, 1e-9}}));
  share_planes(faces);
  const Plane& plane = faces[0].plane;
  for (std::size_t k = 1; k < 20; ++k) {
    const Plane& other = faces[k].plane;
    const double sign = k % 2 == 1 ? -1 : 1;
    CHECK((other.normal == sign * plane.normal && other.d == sign * plane.d));
  }
  CHECK(!(faces[20].plane.normal == plane.normal));
}

TEST_CASE("the built-in worlds are made of flat faces with area") {
  for (const char* kind : {"room", "tilted", "parallel", "three", "wall", "slats"}) {
    CAPTURE(kind);
    const Source source = kind_of_name(kind);
    for (const Face& face : source.faces) {
      CHECK(!face.parts.empty());
      for (const Convex& part : face.parts) {
        for (const Vector& p : part) CHECK(std::abs(face.plane.distance(p)) <= 1e-14);
      }
    }
    CHECK(problem_of(source.light.corners).empty());
    CHECK(face_of(source.light.corners).plane.normal.z < -0.999999);
  }
}

}  // namespace moire::test
