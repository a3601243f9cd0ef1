// Curves as chords: never farther from the curve than promised, the same both ways; and how far a drawing reaches.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>

#include <moire/random.h>

#include "drawing/bounds.h"
#include "drawing/chords.h"
#include "drawing/outlines.h"
#include "message_of.h"
#include "plugins/cartoon/drawn.h"

namespace moire::test {
namespace {

// A place on the curve by de Casteljau's construction, or on the arc.
Point on_curve(cartoon::Verb verb, Point from, const Point* p, double t) {
  if (verb == cartoon::Verb::arc) {
    const double angle = p[3].x + (p[3].y - p[3].x) * t;
    return {p[0].x + p[1].x * std::cos(angle) + p[2].x * std::sin(angle),
            p[0].y + p[1].y * std::cos(angle) + p[2].y * std::sin(angle)};
  }
  std::vector<Point> points{from};
  points.insert(points.end(), p, p + points_of(verb));
  for (; points.size() > 1; points.pop_back()) {
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      points[k] = {points[k].x + t * (points[k + 1].x - points[k].x),
                   points[k].y + t * (points[k + 1].y - points[k].y)};
    }
  }
  return points.front();
}

double distance_to_chord(Point p, Point a, Point b) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const double t = square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

// The largest distance of the curve from its chords.
double error_of(cartoon::Verb verb, Point from, const Point* p, std::size_t chords) {
  std::vector<Point> ends{from};
  cartoon::put_chords(verb, from, p, chords, [&](Point end) { ends.push_back(end); });
  REQUIRE(ends.size() == chords + 1);
  double largest = 0;
  for (std::size_t c = 0; c < chords; ++c) {
    for (int i = 1; i < 16; ++i) {
      const double t = (static_cast<double>(c) + i / 16.0) / static_cast<double>(chords);
      largest = std::max(largest, distance_to_chord(on_curve(verb, from, p, t), ends[c], ends[c + 1]));
    }
  }
  return largest;
}

// A path of one curve with corners anywhere.
cartoon::Drawing random_curve(int k) {
  const auto draw = [&](std::uint32_t dimension) { return 100 * random({.x = k}, 0, dimension); };
  switch (k % 3) {
    case 0:
      return drawn(fmt::format("M {} {} Q {} {} {} {}", draw(0), draw(1), draw(2), draw(3), draw(4), draw(5)));
    case 1:
      return drawn(fmt::format("M {} {} C {} {} {} {} {} {}", draw(0), draw(1), draw(2), draw(3), draw(4), draw(5),
                               draw(6), draw(7)));
    default:
      return drawn(fmt::format("M {} {} A {} {} {} {} {} {} {}", draw(0), draw(1), draw(2) + 1, draw(3) + 1, draw(4),
                               int(draw(5) < 50), int(draw(6) < 50), draw(7), draw(8)),
                   {1, 0.7, 3, -0.2, 0.5, 4});
  }
}

}  // namespace

TEST_CASE("no curve is farther from its chords than the tolerance") {
  for (int k = 0; k < 300; ++k) {
    const cartoon::Drawing drawing = random_curve(k);
    const cartoon::Verb verb = drawing.verbs[1];
    const Point from = drawing.points[0], *p = &drawing.points[1];
    for (const double tolerance : {10.0, 0.5, 0.05, 0.001}) {
      const double chords = cartoon::chords_of(verb, from, p, tolerance);
      CAPTURE(k, tolerance, chords);
      CHECK(error_of(verb, from, p, static_cast<std::size_t>(chords)) <= tolerance * (1 + 1e-9));
    }
  }
}

TEST_CASE("circles and parabolas take no more chords than they must") {
  // The bound is sharp for a parabola, and for a circle to the fourth power of the angle.
  const Point from{0, 0}, parabola[] = {{50, 100}, {100, 0}};
  const double chords = cartoon::chords_of(cartoon::Verb::quadratic, from, parabola, 0.05);
  CHECK(error_of(cartoon::Verb::quadratic, from, parabola, static_cast<std::size_t>(chords) - 1) > 0.05);
  const Point circle[] = {{0, 0}, {100, 0}, {0, 100}, {0, 2 * std::numbers::pi}, {100, 0}};
  const double sides = cartoon::chords_of(cartoon::Verb::arc, {100, 0}, circle, 0.05);
  CHECK(error_of(cartoon::Verb::arc, {100, 0}, circle, static_cast<std::size_t>(sides) - 1) > 0.05);
}

TEST_CASE("a curve drawn backward has the same points to the bit") {
  for (int k = 0; k < 200; ++k) {
    const auto draw = [&](std::uint32_t dimension) { return random({.x = k, .seed = 1}, 0, dimension); };
    // Every fifth one ends where it begins.
    const Point a{draw(0), draw(1)}, b{draw(2), draw(3)}, c{draw(4), draw(5)},
        d = k % 5 == 0 ? a : Point{draw(6), draw(7)};
    const auto points = [](cartoon::Verb verb, Point from, std::vector<Point> p) {
      std::vector<Point> all{from};
      cartoon::put_chords(verb, from, p.data(), 13, [&](Point q) { all.push_back(q); });
      return all;
    };
    std::vector<Point> back = points(cartoon::Verb::cubic, d, {c, b, a});
    std::ranges::reverse(back);
    CHECK(points(cartoon::Verb::cubic, a, {b, c, d}) == back);
    if (a == d) continue;  // there and back on one line
    back = points(cartoon::Verb::quadratic, d, {b, a});
    std::ranges::reverse(back);
    CHECK(points(cartoon::Verb::quadratic, a, {b, d}) == back);
  }
}

TEST_CASE("outlines keep lines as they are, and leave out what encloses nothing") {
  const cartoon::Outlines outlines(drawn("M 0 0 L 4 0 L 4 0 L 4 3 L 0 0 Z M 9 9 L 8 8 Z M 1 1 L 2 1 L 2 2"), 0.1,
                                   Blend::linear);
  const Polygon polygon = outlines.polygon(0, outlines.points());
  CHECK(std::vector(polygon.points.begin(), polygon.points.end()) ==
        std::vector<Point>{{0, 0}, {4, 0}, {4, 3}, {1, 1}, {2, 1}, {2, 2}});
  CHECK(std::vector(polygon.contours.begin(), polygon.contours.end()) == std::vector<std::uint32_t>{0, 3});
  CHECK(polygon.element == 1);
}

TEST_CASE("outlines of more points than memory should hold are refused") {
  CHECK(message_of([] { cartoon::Outlines(drawn("M -1e8 0 Q 0 2e8 1e8 0"), 1e-9, Blend::linear); }) ==
        "cartoon: the outlines take 3.16e+08 points at this scale; at most 6.71e+07 are drawn, with a larger "
        "\"tolerance\" or a smaller \"view.zoom\" they are fewer");
}

TEST_CASE("the box around a curve touches it and holds all of it") {
  for (int k = 0; k < 300; ++k) {
    CAPTURE(k);
    const cartoon::Drawing drawing = random_curve(k);
    const std::optional<cartoon::Box> box = cartoon::bounds_of(drawing);
    REQUIRE(box);
    double low_x = INFINITY, high_x = -INFINITY, low_y = INFINITY, high_y = -INFINITY;
    constexpr int count = 20000;
    for (int i = 0; i <= count; ++i) {
      const Point p = on_curve(drawing.verbs[1], drawing.points[0], &drawing.points[1], double(i) / count);
      low_x = std::min(low_x, p.x), high_x = std::max(high_x, p.x);
      low_y = std::min(low_y, p.y), high_y = std::max(high_y, p.y);
    }
    // Between samples a curve rises over them by at most |P''| / 8 count^2, with |P''| below 1e4 here.
    const double sampled = 1e4 / 8 / count / count;
    CHECK(box->x <= low_x + 1e-11);
    CHECK(box->y <= low_y + 1e-11);
    CHECK(box->x >= low_x - sampled);
    CHECK(box->y >= low_y - sampled);
    CHECK(std::abs(box->x + box->width - high_x) <= sampled);
    CHECK(std::abs(box->y + box->height - high_y) <= sampled);
  }
}

}  // namespace moire::test
