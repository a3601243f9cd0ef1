// What points see of a drawing, held to winding numbers in whole numbers. No point may be wrong.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include <moire/random.h>

#include "plugins/cartoon/brute_force.h"
#include "plugins/cartoon/drawn.h"

namespace moire::test {
namespace {

constexpr ImageSize size{40, 30};
constexpr std::int64_t steps = LatticeDrawing::steps;

// Sites of the lattice over the image and a little beyond it: columns from left to right, each from below upward.
std::vector<Site> sites() {
  std::vector<Site> all;
  for (std::int64_t x = -2 * steps; x <= (size.width + 2) * steps; x += 3) {
    for (std::int64_t y = (size.height + 2) * steps; y >= -2 * steps; y -= 2) all.push_back({x, y});
  }
  return all;
}

SamplePoint point_at(Site site) { return {static_cast<double>(site.x) / steps, static_cast<double>(site.y) / steps}; }

std::vector<SamplePoint> points_at(const std::vector<Site>& all) {
  std::vector<SamplePoint> points;
  for (const Site site : all) points.push_back(point_at(site));
  return points;
}

// In another order, the same for the same seed.
std::vector<SamplePoint> shuffled(std::vector<SamplePoint> points, std::uint64_t seed) {
  for (std::size_t k = points.size(); k > 1; --k) {
    std::swap(points[k - 1], points[static_cast<std::size_t>(random({.x = static_cast<int>(k), .seed = seed}, 0, 9) *
                                                             static_cast<double>(k))]);
  }
  return points;
}

}  // namespace

TEST_CASE("points see the topmost layer that winds around them, under both fill rules") {
  const std::vector<Site> all = sites();
  std::size_t judged = 0, wrong = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    const LatticeDrawing drawing = random_drawing(seed % 2 == 0 ? 3 : 12, 3 + static_cast<int>(seed % 9), size, seed);
    const auto frame = frame_of(drawing.drawing(), size);
    const std::vector<Element> seen = together(*frame, points_at(all));
    for (std::size_t k = 0; k < all.size(); ++k) {
      const std::optional<Element> expected = seen_at(drawing, all[k]);
      if (!expected) continue;
      ++judged;
      wrong += seen[k] != *expected;
    }
  }
  CHECK(wrong == 0);
  CHECK(judged > 450000);  // few lie on edges
}

TEST_CASE("more layers than a machine word has bits") {
  LatticeDrawing drawing;
  // Steps: layer k covers all right of x = k / 8, so there layer k is on top.
  constexpr std::int64_t count = 5000;
  for (std::int64_t k = 0; k < count; ++k) {
    drawing.layers.push_back({FillRule::nonzero, {{{k, -8}, {count, -8}, {count, 800}, {k, 800}}}});
  }
  const auto frame = frame_of(drawing.drawing(), {640, 8});
  for (std::int64_t k = 0; k < count; k += 7) {
    const SamplePoint point{(static_cast<double>(k) + 0.5) / steps, 4};
    CHECK(together(*frame, std::vector{point}).front() == static_cast<Element>(k + 1));
  }
}

TEST_CASE("a point's answer does not depend on its batch") {
  for (std::uint64_t seed = 100; seed < 106; ++seed) {
    CAPTURE(seed);
    const auto frame = frame_of(random_drawing(9, 8, size, seed).drawing(), size);
    std::vector<SamplePoint> points = points_at(sites());
    const std::vector<Element> column_by_column = together(*frame, points);
    CHECK(one_by_one(*frame, points) == column_by_column);
    // Downward, scattered, and pixel columns of scattered points.
    std::vector<SamplePoint> downward(points.rbegin(), points.rend());
    std::vector<Element> reversed = together(*frame, downward);
    std::ranges::reverse(reversed);
    CHECK(reversed == column_by_column);
    const std::vector<SamplePoint> scattered = shuffled(points, seed);
    CHECK(together(*frame, scattered) == one_by_one(*frame, scattered));
    std::ranges::stable_sort(points = scattered, {}, [](const SamplePoint& p) { return std::floor(p.x); });
    CHECK(together(*frame, points) == one_by_one(*frame, points));
  }
}

TEST_CASE("points on edges and corners belong to the lower side, or to the right one") {
  // A diamond: its left corner and upper edges are in, its right corner and lower edges are not.
  const auto diamond = frame_of(drawn("M 2 4 L 4 2 L 6 4 L 4 6 Z"), size);
  const std::vector<SamplePoint> points{{2, 4}, {3, 3}, {4, 2}, {5, 3}, {6, 4}, {5, 5}, {4, 6}, {3, 5}, {4, 4}};
  CHECK(together(*diamond, points) == std::vector<Element>{0, 1, 1, 1, 0, 0, 0, 0, 1});
  const auto square = frame_of(drawn("M 2 2 H 4 V 4 H 2 Z"), size);
  const std::vector<SamplePoint> border{{2, 2}, {3, 2}, {4, 2}, {4, 3}, {4, 4}, {3, 4}, {2, 4}, {2, 3}};
  CHECK(together(*square, border) == std::vector<Element>{1, 1, 0, 0, 0, 0, 0, 1});
}

TEST_CASE("points on edges that two layers share, and on their corners, belong to exactly one of them") {
  // A mesh of triangles over the image whose inner corners are anywhere.
  constexpr int cells = 6;
  Point corners[cells + 1][cells + 1];
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j) {
      const auto off = [&](int at, std::uint32_t dimension) {
        return at == 0 || at == cells ? 0 : 0.6 * random({.x = i, .y = j}, 0, dimension) - 0.3;
      };
      corners[i][j] = {(i + off(i, 0)) * size.width / cells, (j + off(j, 1)) * size.height / cells};
    }
  }
  std::vector<std::unique_ptr<Frame>> triangles;
  std::vector<SamplePoint> points;
  const auto add = [&](Point a, Point b, Point c, bool backward) {
    if (backward) std::swap(b, c);
    triangles.push_back(frame_of(
        drawn(fmt::format("M {:.17g} {:.17g} L {:.17g} {:.17g} L {:.17g} {:.17g} Z", a.x, a.y, b.x, b.y, c.x, c.y)),
        size));
    for (const auto& [p, q] : {std::pair{a, b}, {b, c}, {c, a}}) {
      points.push_back({p.x, p.y});
      for (int k = 1; k < 20; ++k) points.push_back({p.x + (q.x - p.x) * k / 20, p.y + (q.y - p.y) * k / 20});
    }
  };
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      add(corners[i][j], corners[i + 1][j], corners[i + 1][j + 1], (i + j) % 2 == 0);
      add(corners[i][j], corners[i + 1][j + 1], corners[i][j + 1], (i + j) % 3 == 0);
    }
  }
  // The mesh ends at the right and lower border.
  std::erase_if(points, [](const SamplePoint& p) { return p.x >= size.width || p.y >= size.height; });
  std::vector<int> covered(points.size(), 0);
  for (const auto& triangle : triangles) {
    const std::vector<Element> seen = together(*triangle, points);
    for (std::size_t k = 0; k < points.size(); ++k) covered[k] += seen[k] != background;
  }
  CHECK(std::ranges::count(covered, 1) == std::ssize(covered));
}

TEST_CASE("trace counts points, and those that see a layer") {
  const auto square = frame_of(drawn("M 2 2 H 4 V 4 H 2 Z"), size);
  for (const std::vector<SamplePoint>& points :
       {std::vector<SamplePoint>{{3, 9}, {3, 3}, {3, 2.5}, {3, 1}}, {{3, 3}, {3.5, 9}, {3.1, 3}, {3.2, 1}}}) {
    std::vector<Hit> hits(points.size());
    Counters counters;
    square->trace(points, hits, counters);
    CHECK(counters == Counters{.queries = 4, .hits = 2});
  }
  Counters counters;
  square->trace({}, {}, counters);
  CHECK(counters == Counters{});
}

TEST_CASE("hits have the colours of their layers, or that of the background") {
  cartoon::Drawing drawing = drawn("M 2 2 H 4 V 4 H 2 Z");
  drawing.layers[0].color = {255, 0, 51};
  const auto frame = frame_of(drawing, size);
  const std::vector<SamplePoint> points{{3, 3}, {3, 1}};
  std::vector<Hit> hits(2);
  Counters counters;
  frame->trace(points, hits, counters);
  CHECK(hits[0].color == Color{1, 0, static_cast<float>(srgb_to_linear(0.2))});
  CHECK(hits[1].color == Color{1, 1, 1});
}

}  // namespace moire::test
