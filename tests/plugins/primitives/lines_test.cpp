// What image lines see of lines and circles: held to places found another way, in long double, to points set close
// together, and to numbers known on paper.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <map>

#include <moire/random.h>

#include "plugins/primitives/brute_force.h"
#include "support/lengths.h"

namespace moire::test {
namespace {

constexpr ImageSize size{80, 60};

using Curves = std::vector<primitives::Curve>;

// On a line of one stretch.
std::map<Element, double> lengths(const Curves& curves, Point from, Point to) {
  const std::vector<double> cuts{0, std::hypot(to.x - from.x, to.y - from.y)};
  return along(*frame_of(curves, size), {from, to, cuts}).front();
}

using Places = std::vector<long double>;

// Where a line, as parts of its length, meets a circle: the roots of a quadratic equation.
void meet_circle(const ImageLine& line, Point center, long double radius, Places& places) {
  const long double dx = static_cast<long double>(line.to.x) - line.from.x,
                    dy = static_cast<long double>(line.to.y) - line.from.y,
                    cx = static_cast<long double>(line.from.x) - center.x,
                    cy = static_cast<long double>(line.from.y) - center.y;
  const long double a = dx * dx + dy * dy, b = cx * dx + cy * dy, c = cx * cx + cy * cy - radius * radius;
  const long double inside = b * b - a * c;
  if (inside < 0) return;
  places.push_back((-b - std::sqrt(inside)) / a);
  places.push_back((-b + std::sqrt(inside)) / a);
}

// Where it meets the sides and ends of a rectangle, as four straight lines without end.
void meet_rectangle(const ImageLine& line, const LineCurve& curve, Places& places) {
  const long double dx = static_cast<long double>(curve.to.x) - curve.from.x,
                    dy = static_cast<long double>(curve.to.y) - curve.from.y, length = std::hypot(dx, dy);
  const long double ux = length > 0 ? dx / length : 1, uy = length > 0 ? dy / length : 0;
  const long double half = curve.width / 2.0L, longer = curve.cap == Cap::square ? half : 0;
  const long double lx = static_cast<long double>(line.to.x) - line.from.x,
                    ly = static_cast<long double>(line.to.y) - line.from.y;
  const long double px = static_cast<long double>(line.from.x) - curve.from.x,
                    py = static_cast<long double>(line.from.y) - curve.from.y;
  const auto cross = [&](long double nx, long double ny, long double at) {
    const long double rate = nx * lx + ny * ly;
    if (rate != 0) places.push_back((at - (nx * px + ny * py)) / rate);
  };
  cross(-uy, ux, half);
  cross(-uy, ux, -half);
  cross(ux, uy, -longer);
  cross(ux, uy, length + longer);
}

// All places at which it may see something else, and what the middle of each part sees.
Lengths by_places(const Curves& curves, const ImageLine& line) {
  Places places;
  const long double length =
      std::hypot(static_cast<long double>(line.to.x) - line.from.x, static_cast<long double>(line.to.y) - line.from.y);
  for (const auto& curve : curves) {
    if (const auto* l = std::get_if<LineCurve>(&curve)) {
      meet_rectangle(line, *l, places);
      meet_circle(line, l->from, l->width / 2.0L, places);
      meet_circle(line, l->to, l->width / 2.0L, places);
    } else {
      const auto& circle = std::get<CircleCurve>(curve);
      meet_circle(line, circle.center, circle.radius + circle.width / 2.0L, places);
      meet_circle(line, circle.center, std::abs(circle.radius - circle.width / 2.0L), places);
    }
  }
  for (long double& place : places) place *= length;
  std::erase_if(places, [&](long double p) { return !(p > line.cuts.front() && p < line.cuts.back()); });
  places.insert(places.end(), line.cuts.begin(), line.cuts.end());
  std::ranges::sort(places);
  Lengths lengths(line.stretches());
  for (std::size_t p = 0; p + 1 < places.size(); ++p) {
    const long double middle = (places[p] + places[p + 1]) / 2, part = middle / length;
    const Point point{static_cast<double>(line.from.x + (line.to.x - line.from.x) * part),
                      static_cast<double>(line.from.y + (line.to.y - line.from.y) * part)};
    const auto seen = seen_at(curves, point, 0);
    const auto stretch = std::ranges::upper_bound(line.cuts, static_cast<double>(middle)) - line.cuts.begin() - 1;
    lengths[std::min(static_cast<std::size_t>(stretch), line.stretches() - 1)][*seen] +=
        static_cast<double>(places[p + 1] - places[p]);
  }
  return lengths;
}

double difference(const Lengths& one, const Lengths& other) {
  double largest = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    std::map<Element, double> apart = one[i];
    for (const auto& [element, length] : other[i]) apart[element] -= length;
    for (const auto& [element, length] : apart) largest = std::max(largest, std::abs(length));
  }
  return largest;
}

struct AnyLine {
  Point from, to;
  std::vector<double> cuts;
  operator ImageLine() const { return {from, to, cuts}; }
};

// Every fourth is upright, every fourth level; some begin or end beyond the image.
AnyLine random_line(int k, std::uint64_t seed) {
  const auto draw = [&](std::uint32_t dimension) { return random({.x = k, .seed = seed}, 2, dimension); };
  const double beyond = k % 3 == 0 ? 60 : 10;
  const auto place = [&](int extent, std::uint32_t dimension) {
    return (extent + 2 * beyond) * draw(dimension) - beyond;
  };
  AnyLine line{{place(size.width, 0), place(size.height, 1)}, {place(size.width, 2), place(size.height, 3)}, {0}};
  if (k % 4 == 0) line.to.x = line.from.x;
  if (k % 4 == 1) line.to.y = line.from.y;
  const double length = std::hypot(line.to.x - line.from.x, line.to.y - line.from.y);
  while (line.cuts.back() + 2.7 < length) line.cuts.push_back(line.cuts.back() + 2.7);
  line.cuts.push_back(length);
  return line;
}

}  // namespace

TEST_CASE("image lines in any direction see the foremost curves, in the amounts of an independent derivation") {
  double worst = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Curves curves = random_curves(30, size, seed);
    const auto frame = frame_of(curves, size);
    for (int k = 0; k < 40; ++k) {
      const AnyLine line = random_line(k, seed);
      CAPTURE(seed, k);
      const double apart = difference(along(*frame, line), by_places(curves, line));
      // Places on the line are off by some 1e-13 pixels, coordinates of 200 in double, over the sine of the angle at
      // which it meets an outline, which is above 0.01 for nearly all of them.
      CHECK(apart < 1e-11);
      worst = std::max(worst, apart);
    }
  }
  CHECK(worst > 0);  // two derivations, not one
}

TEST_CASE("image lines see what points set close together on them see") {
  const Curves curves = random_curves(300, size, 5);
  const auto frame = frame_of(curves, size);
  constexpr int points = 40000;
  for (int k = 0; k < 12; ++k) {
    const AnyLine line = random_line(k, 77);
    const double length = line.cuts.back();
    const std::vector<double> one_stretch{0, length};
    const auto exact = along(*frame, {line.from, line.to, one_stretch}).front();
    std::vector<Point> places;
    for (int i = 0; i < points; ++i) {
      const double part = (i + 0.5) / points;
      places.push_back(
          {line.from.x + part * (line.to.x - line.from.x), line.from.y + part * (line.to.y - line.from.y)});
    }
    std::map<Element, double> sampled;
    for (const Element element : elements_at(*frame, places)) sampled[element] += length / points;
    // Each run is off by at most one step between points at either end; no element has more than 40 runs here.
    for (const auto& [element, amount] : exact) {
      CAPTURE(k, element);
      CHECK(std::abs(amount - sampled[element]) < 40 * length / points);
    }
  }
}

TEST_CASE("image lines see chords of rings and stretches of lines as they are on paper") {
  const Curves ring{CircleCurve{1, {}, {40, 30}, 15, 20}};  // between 5 and 25
  // Through the middle, 3 and 7 aside.
  CHECK(lengths(ring, {40, 0}, {40, 60}) == std::map<Element, double>{{0, 20}, {1, 40}});
  auto seen = lengths(ring, {43, 0}, {43, 60});
  CHECK(std::abs(seen[1] - (2 * std::sqrt(616.0) - 8)) < 1e-13);
  seen = lengths(ring, {33, 0}, {33, 60});
  CHECK(std::abs(seen[1] - 48) < 1e-13);
  // At 3 : 4 : 5 through the middle.
  seen = lengths(ring, {40 - 24, 30 - 18}, {40 + 24, 30 + 18});
  CHECK(std::abs(seen[1] - 40) < 1e-13);

  const Curves bar{LineCurve{1, {}, {10, 20}, {50, 50}, 5, Cap::butt}};  // 50 long, direction (4, 3)
  seen = lengths(bar, {30, 0}, {30, 60});
  CHECK(std::abs(seen[1] - 5 / 0.8) < 1e-13);
  seen = lengths(bar, {2, 14}, {66, 62});  // along its axis
  CHECK(std::abs(seen[1] - 50) < 1e-13);
  seen = lengths({LineCurve{1, {}, {10, 20}, {50, 50}, 5, Cap::round}}, {2, 14}, {66, 62});
  CHECK(std::abs(seen[1] - 55) < 1e-13);
  seen = lengths({LineCurve{1, {}, {10, 20}, {50, 50}, 5, Cap::square}}, {2, 14}, {66, 62});
  CHECK(std::abs(seen[1] - 55) < 1e-13);
}

TEST_CASE("an image line that touches a curve sees it only where it enters it") {
  const Curves ring{CircleCurve{1, {}, {40, 30}, 15, 20}};
  using Seen = std::map<Element, double>;
  // The outer circle, on either side: nothing. The inner one: all of the chord.
  CHECK(lengths(ring, {65, 0}, {65, 60}) == Seen{{0, 60}});
  CHECK(lengths(ring, {15, 0}, {15, 60}) == Seen{{0, 60}});
  CHECK(lengths(ring, {0, 5}, {80, 5}) == Seen{{0, 80}});
  auto seen = lengths(ring, {45, 0}, {45, 60});
  CHECK(std::abs(seen[1] - 2 * std::sqrt(600.0)) < 1e-13);
  // Nearly: a chord of 2 sqrt(2 r e), 2e-4 or more, between places rounded to 4e-15.
  const double e = 0x1p-30;
  seen = lengths(ring, {65 - e, 0}, {65 - e, 60});
  CHECK(std::abs(seen[1] / (2 * std::sqrt(e * (50 - e))) - 1) < 1e-10);
  CHECK(lengths(ring, {65 + e, 0}, {65 + e, 60}) == Seen{{0, 60}});
  // Round ends, likewise.
  const Curves capsule{LineCurve{1, {}, {20, 30}, {60, 30}, 10, Cap::round}};
  CHECK(lengths(capsule, {65, 0}, {65, 60}) == Seen{{0, 60}});
  CHECK(lengths(capsule, {15, 0}, {15, 60}) == Seen{{0, 60}});
  seen = lengths(capsule, {65 - e, 0}, {65 - e, 60});
  CHECK(std::abs(seen[1] / (2 * std::sqrt(e * (10 - e))) - 1) < 1e-10);
}

TEST_CASE("an image line along a straight outline sees what its points see") {
  using Seen = std::map<Element, double>;
  const Curves bar{LineCurve{1, {}, {20, 30}, {60, 30}, 10, Cap::butt}};  // 20 .. 60 by 25 .. 35
  CHECK(lengths(bar, {20, 0}, {20, 60}) == Seen{{0, 50}, {1, 10}});       // its left end is its own
  CHECK(lengths(bar, {60, 0}, {60, 60}) == Seen{{0, 60}});
  CHECK(lengths(bar, {0, 25}, {80, 25}) == Seen{{0, 40}, {1, 40}});  // its upper side, too
  CHECK(lengths(bar, {0, 35}, {80, 35}) == Seen{{0, 80}});
  const Curves reversed{LineCurve{1, {}, {60, 30}, {20, 30}, 10, Cap::butt}};
  CHECK(lengths(reversed, {20, 60}, {20, 0}) == Seen{{0, 50}, {1, 10}});
  CHECK(lengths(reversed, {80, 35}, {0, 35}) == Seen{{0, 80}});
  // Two that share an end and two that share a side: no gap, no overlap, whichever is in front.
  const Curves pair{LineCurve{1, {}, {20, 30}, {40, 30}, 10, Cap::butt},
                    LineCurve{2, {}, {60, 30}, {40, 30}, 10, Cap::butt},
                    LineCurve{3, {}, {20, 40}, {60, 40}, 10, Cap::butt}};
  CHECK(lengths(pair, {40, 0}, {40, 60}) == Seen{{0, 40}, {2, 10}, {3, 10}});
  CHECK(lengths(pair, {0, 35}, {80, 35}) == Seen{{0, 40}, {3, 40}});
  CHECK(lengths(pair, {0, 30}, {80, 30}) == Seen{{0, 40}, {1, 20}, {2, 20}});
}

TEST_CASE("image lines come in the order of their slots, and count their runs") {
  const auto frame = frame_of({LineCurve{1, {}, {2, 3}, {6, 3}, 2, Cap::butt}, CircleCurve{2, {}, {3, 3}, 0, 1}}, size);
  const std::vector<double> cuts{0, 10}, three_cuts{0, 3, 3, 10}, middle{2.5, 3.25};
  const ImageLine lines[] = {
      {{3, 10}, {3, 0}, cuts}, {{1, 10}, {1, 0}, three_cuts}, {{0, 3}, {10, 3}, three_cuts}, {{0, 3}, {10, 3}, middle}};
  Tally pieces(8, true);
  frame->lines()->along(lines, nullptr, pieces);
  std::string text;
  for (std::size_t i = 0; i < 8; ++i) {
    pieces.for_each(i, [&](const Fragment& f) { text += fmt::format("{}:{} ", f.element, f.weight); });
    text += "| ";
  }
  CHECK(text == "0:6 1:0.5 2:1 1:0.5 0:2 | 0:3 | | 0:7 | 0:2 1:0.5 2:0.5 | | 2:0.5 1:2.5 0:4 | 2:0.75 | ");
  CHECK(pieces.counters == Counters{.queries = 6, .hits = 8});
}

}  // namespace moire::test
