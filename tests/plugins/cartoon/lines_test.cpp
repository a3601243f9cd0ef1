// What image lines see of a drawing, held to points on them.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <map>

#include <moire/random.h>

#include "plugins/cartoon/brute_force.h"
#include "plugins/cartoon/drawn.h"
#include "support/lengths.h"

namespace moire::test {
namespace {

constexpr ImageSize size{40, 30};

std::vector<double> cuts_of(double length) {
  std::vector<double> cuts{0};
  while (cuts.back() + 2.7 < length) cuts.push_back(cuts.back() + 2.7);
  cuts.push_back(length);
  return cuts;
}

// By points: where the line may change what it sees, in long double and from all pairs of corners in order, and what
// the middle of each part sees.
Lengths by_points(const Frame& frame, const cartoon::Drawing& drawing, const ImageLine& line) {
  const long double ux = line.to.x - line.from.x, uy = line.to.y - line.from.y, length = std::hypot(ux, uy);
  std::vector<long double> places(line.cuts.begin(), line.cuts.end());
  for (std::size_t k = 0, first = 0; k < drawing.verbs.size(); ++k) {
    if (drawing.verbs[k] == cartoon::Verb::move) first = k;
    const bool is_last = k + 1 == drawing.verbs.size() || drawing.verbs[k + 1] == cartoon::Verb::move;
    const Point a = drawing.points[k], b = drawing.points[is_last ? first : k + 1];
    const long double ex = b.x - a.x, ey = b.y - a.y, dx = a.x - line.from.x, dy = a.y - line.from.y;
    const long double cross = ux * ey - uy * ex;
    if (cross == 0) continue;
    const long double on_line = (dx * ey - dy * ex) / cross, on_edge = (dx * uy - dy * ux) / cross;
    if (on_edge >= 0 && on_edge <= 1 && on_line >= 0 && on_line <= 1) places.push_back(on_line * length);
  }
  std::ranges::sort(places);
  Lengths lengths(line.stretches());
  for (std::size_t p = 0; p + 1 < places.size(); ++p) {
    const long double middle = (places[p] + places[p + 1]) / 2;
    const SamplePoint point{static_cast<double>(line.from.x + ux * middle / length),
                            static_cast<double>(line.from.y + uy * middle / length)};
    const auto stretch = std::ranges::upper_bound(line.cuts, static_cast<double>(middle)) - line.cuts.begin() - 1;
    const auto i = std::min(static_cast<std::size_t>(stretch), line.stretches() - 1);
    lengths[i][one_by_one(frame, std::span(&point, 1)).front()] += static_cast<double>(places[p + 1] - places[p]);
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

}  // namespace

TEST_CASE("lines in any direction see what points on them see, in the same amounts") {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const cartoon::Drawing drawing = random_drawing(6, 7, size, seed).drawing();
    const auto frame = frame_of(drawing, size);
    for (int k = 0; k < 12; ++k) {
      const auto draw = [&](std::uint32_t dimension) { return random({.x = k, .seed = seed}, 0, dimension); };
      Point from{50 * draw(0) - 5, 40 * draw(1) - 5}, to{50 * draw(2) - 5, 40 * draw(3) - 5};
      if (k % 4 == 0) to.x = from.x;
      if (k % 4 == 1) to.y = from.y;
      const std::vector<double> cuts = cuts_of(std::hypot(to.x - from.x, to.y - from.y));
      const ImageLine line{from, to, cuts};
      CAPTURE(seed, from.x, from.y, to.x, to.y);
      // A place on the line is off by at most 1e-14 times the coordinates over the sine of the angle to the edge, here
      // more than 1e-4; 20 edges may bound what a stretch sees of a layer.
      CHECK(difference(along(*frame, line), by_points(*frame, drawing, line)) < 1e-7);
    }
  }
}

TEST_CASE("upright lines through corners and along upright edges see what points at the same x see") {
  for (std::uint64_t seed = 50; seed < 60; ++seed) {
    const cartoon::Drawing drawing = random_drawing(6, 7, size, seed).drawing();
    const auto frame = frame_of(drawing, size);
    for (int x = -1; x <= size.width; ++x) {
      const std::vector<double> cuts = cuts_of(size.height);
      const Point bottom{double(x), double(size.height)}, top{double(x), 0};
      CAPTURE(seed, x);
      const ImageLine upward{bottom, top, cuts}, downward{top, bottom, cuts};
      CHECK(difference(along(*frame, upward), by_points(*frame, drawing, upward)) < 1e-11);
      CHECK(difference(along(*frame, downward), by_points(*frame, drawing, downward)) < 1e-11);
    }
  }
}

TEST_CASE("the pieces of a line fill its stretches") {
  const auto frame = frame_of(random_drawing(6, 7, size, 3).drawing(), size);
  const std::vector<double> cuts{1, 2, 2, 5, 5.5, 30};
  for (const Point to : {Point{7, -3}, {30, 21}, {44, 2}}) {
    const ImageLine line{{7, 40}, to, cuts};
    Counters counters;
    const Lengths lengths = along(*frame, line, &counters);
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      double sum = 0;
      for (const auto& [element, length] : lengths[i]) sum += length;
      CHECK(std::abs(sum - (cuts[i + 1] - cuts[i])) < 1e-13);
    }
    CHECK(counters.queries == 4);  // one stretch has no length
  }
}

TEST_CASE("lines come in the order of their slots, and count runs") {
  const auto frame = frame_of(drawn("M 2 2 H 4 V 4 H 2 Z M 2 5 H 4 V 6 H 2 Z"), size);
  const std::vector<double> cuts{0, 10}, two_cuts{0, 3, 10};
  const ImageLine lines[] = {{{3, 10}, {3, 0}, cuts}, {{1, 10}, {1, 0}, two_cuts}, {{0, 3}, {10, 3}, two_cuts}};
  Tally pieces(5, true);
  frame->lines()->along(lines, nullptr, pieces);
  std::string text;
  for (std::size_t i = 0; i < 5; ++i) {
    pieces.for_each(i, [&](const Fragment& f) { text += fmt::format("{}:{} ", f.element, f.weight); });
    text += "| ";
  }
  CHECK(text == "0:4 1:1 0:1 1:2 0:2 | 0:3 | 0:7 | 0:2 1:1 | 1:1 0:6 | ");
  CHECK(pieces.counters == Counters{.queries = 5, .hits = 4});
}

}  // namespace moire::test
