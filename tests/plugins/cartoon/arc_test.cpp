// Elliptical arcs of path data against the equation of the ellipse.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

#include <moire/random.h>

#include "drawing/chords.h"
#include "plugins/cartoon/drawn.h"

namespace moire::test {
namespace {

struct Arc {
  Point center, u, v;
  double a, b;
  Point end;
};

Arc arc_of(const cartoon::Drawing& drawing) {
  REQUIRE(drawing.verbs == std::vector{cartoon::Verb::move, cartoon::Verb::arc});
  const auto& p = drawing.points;
  return {p[1], p[2], p[3], p[4].x, p[4].y, p[5]};
}

Point at(const Arc& arc, double t) {
  const double c = std::cos(t), s = std::sin(t);
  return {arc.center.x + arc.u.x * c + arc.v.x * s, arc.center.y + arc.u.y * c + arc.v.y * s};
}

double distance(Point p, Point q) { return std::hypot(p.x - q.x, p.y - q.y); }

// 0 on the ellipse with these radii and this turn about `center`.
double off_ellipse(Point p, Point center, double rx, double ry, double degrees) {
  const double angle = degrees * std::numbers::pi / 180, dx = p.x - center.x, dy = p.y - center.y;
  const double x = (dx * std::cos(angle) + dy * std::sin(angle)) / rx;
  const double y = (dy * std::cos(angle) - dx * std::sin(angle)) / ry;
  return x * x + y * y - 1;
}

}  // namespace

TEST_CASE("arcs lie on an ellipse of their radii and turn, from end to end, the way round that the flags say") {
  for (int k = 0; k < 500; ++k) {
    const auto draw = [&](std::uint32_t dimension) { return random({.x = k}, 0, dimension); };
    const Point from{19 * draw(0) - 9, 19 * draw(1) - 9}, to{19 * draw(2) - 9, 19 * draw(3) - 9};
    const double rx = 15 + 20 * draw(4), ry = 15 + 20 * draw(5), degrees = 720 * draw(6) - 360;
    for (const bool large : {false, true}) {
      for (const bool rising : {false, true}) {
        const auto data = fmt::format("M {:.17g} {:.17g} A {:.17g} {:.17g} {:.17g} {:d} {:d} {:.17g} {:.17g}", from.x,
                                      from.y, rx, ry, degrees, large, rising, to.x, to.y);
        CAPTURE(data);
        const Arc arc = arc_of(drawn(data));
        CHECK(arc.end == to);
        // Half the chord is at most 15/16 of the smaller radius: nothing is ill-conditioned.
        CHECK(distance(at(arc, arc.a), from) < 1e-12);
        CHECK(distance(at(arc, arc.b), to) < 1e-12);
        CHECK((arc.b > arc.a) == rising);
        CHECK((std::abs(arc.b - arc.a) > std::numbers::pi) == large);
        CHECK(std::abs(arc.b - arc.a) <= 2 * std::numbers::pi);
        for (int i = 0; i <= 20; ++i) {
          const Point p = at(arc, arc.a + (arc.b - arc.a) * i / 20);
          CHECK(std::abs(off_ellipse(p, arc.center, rx, ry, degrees)) < 1e-12);
        }
      }
    }
  }
}

TEST_CASE("a quarter of a circle goes clockwise on the screen when its sweep flag is set") {
  const Arc clockwise = arc_of(drawn("M 0 -5 A 5 5 0 0 1 5 0")), against = arc_of(drawn("M 0 -5 A 5 5 0 0 0 5 0"));
  CHECK(distance(clockwise.center, {0, 0}) < 1e-14);
  CHECK(distance(against.center, {5, -5}) < 1e-14);
}

TEST_CASE("radii that are too small grow until the ellipse reaches") {
  for (const auto& [rx, ry] : {std::pair{1.0, 1.0}, {1e-3, 1e-3}, {1e-200, 1e-200}}) {
    const Arc arc = arc_of(drawn(fmt::format("M 0 0 A {} {} 0 0 1 10 0", rx, ry)));
    CHECK(distance(arc.center, {5, 0}) < 1e-14);
    CHECK(std::abs(std::hypot(arc.u.x, arc.u.y) - 5) < 1e-14);
    CHECK(std::abs(std::abs(arc.b - arc.a) - std::numbers::pi) < 1e-14);
  }
  const Arc flat = arc_of(drawn("M 0 0 A 2 1 0 0 1 10 0"));
  CHECK(std::abs(std::hypot(flat.u.x, flat.u.y) - 5) < 1e-14);
  CHECK(std::abs(std::hypot(flat.v.x, flat.v.y) - 2.5) < 1e-14);
}

TEST_CASE("arcs without radii are lines, and those without length are nothing") {
  CHECK(shown(drawn("M 0 0 A 0 5 0 0 1 10 0")) == "M 0,0 L 10,0");
  CHECK(shown(drawn("M 0 0 A 5 0 0 0 1 10 0")) == "M 0,0 L 10,0");
  CHECK(shown(drawn("M 0 0 A 5 5 0 1 1 0 0")) == "");
  CHECK(shown(drawn("M 0 0 A -5 5 0 0 1 10 0")) == shown(drawn("M 0 0 A 5 5 0 0 1 10 0")));
}

TEST_CASE("an arc and the same arc drawn backward give the same points to the bit") {
  for (int k = 0; k < 200; ++k) {
    const auto draw = [&](std::uint32_t dimension) { return random({.x = k}, 0, dimension); };
    const Point p{20 * draw(0), 20 * draw(1)}, q{20 * draw(2), 20 * draw(3)};
    const double rx = 1 + 20 * draw(4), ry = 1 + 20 * draw(5), degrees = 360 * draw(6);
    const bool large = draw(7) < 0.5, rising = draw(8) < 0.5;
    const auto arc_between = [&](Point from, Point to, bool up) {
      const cartoon::Drawing drawing =
          drawn(fmt::format("M {:.17g} {:.17g} A {:.17g} {:.17g} {:.17g} {:d} {:d} {:.17g} {:.17g}", from.x, from.y, rx,
                            ry, degrees, large, up, to.x, to.y));
      std::vector<Point> points{from};
      cartoon::put_chords(cartoon::Verb::arc, from, &drawing.points[1], 17, [&](Point c) { points.push_back(c); });
      return points;
    };
    const std::vector<Point> there = arc_between(p, q, rising), back = arc_between(q, p, !rising);
    CHECK(there == std::vector<Point>(back.rbegin(), back.rend()));
  }
}

}  // namespace moire::test
