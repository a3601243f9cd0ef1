// Exact pixels of every kind: against clipped polygons, against points, against themselves at twice the size.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>
#include <set>

#include "clipped_area.h"
#include "numbers.h"
#include "pattern_frames.h"

namespace moire::test {

namespace {

constexpr ImageSize size{23, 18};

// Calls check(x, y) for all pixels.
template <class Check>
void for_each_pixel(Check check) {
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) check(x, y);
  }
}

std::vector<Hit> traced(const Frame& frame, const std::vector<SamplePoint>& points) {
  std::vector<Hit> hits(points.size());
  Counters counters;
  frame.trace(points, hits, counters);
  return hits;
}

long double turn(double degrees) { return degrees * std::numbers::pi_v<long double> / 180; }

// The area in a pixel of what lies between two lines across `angle_deg`, at these distances from `middle`.
long double stripe_area(int x, int y, LongPoint middle, double angle_deg, long double from, long double to) {
  const long double c = std::cos(turn(angle_deg)), s = std::sin(turn(angle_deg));
  const auto distance = [&](LongPoint p) { return c * (p.x - middle.x) + s * (p.y - middle.y); };
  const LongPolygon above = clipped(pixel_square(x, y), [&](LongPoint p) { return distance(p) - from; });
  return area(clipped(above, [&](LongPoint p) { return to - distance(p); }));
}

constexpr double angles[] = {0, 1e-12, 1e-6, 1e-3, 0.05, 10, 45, 45.0001, 90, 133, 180, 270, -77};

}  // namespace

TEST_CASE("every pixel of every pattern is full, and its recorded fragments make its colour") {
  for (const Example& example : examples()) {
    CAPTURE(example.name);
    const MadePattern made = made_pattern(example.changes, size);
    const ExactPixels exact(*made.frame);
    CHECK(exact.bound == 0);
    for_each_pixel([&](int x, int y) {
      double weight = 0, red = 0;
      std::set<Element> elements;
      for (const Fragment& f : exact.fragments(x, y)) {
        CHECK(f.weight > 0);
        CHECK(elements.insert(f.element).second);
        weight += f.weight, red += f.weight * f.color.r;
      }
      CHECK(std::abs(weight - 1) < 1e-14);
      CHECK(std::abs(red - exact.red(x, y)) < 1e-14);
    });
  }
}

TEST_CASE("a pixel holds what its quarters hold, as an image of twice the size shows them") {
  for (const Example& example : examples()) {
    CAPTURE(example.name);
    const MadePattern made = made_pattern(example.changes, size);
    const MadePattern twice = made_pattern(with(example.changes, example.twice), {2 * size.width, 2 * size.height});
    const ExactPixels exact(*made.frame), quarters(*twice.frame);
    double largest = 0;
    for_each_pixel([&](int x, int y) {
      const double sum = quarters.red(2 * x, 2 * y) + quarters.red(2 * x + 1, 2 * y) + quarters.red(2 * x, 2 * y + 1) +
                         quarters.red(2 * x + 1, 2 * y + 1);
      largest = std::max(largest, std::abs(exact.red(x, y) - sum / 4));
    });
    CHECK(largest < (is_smooth(example) ? 0x1p-23 : 1e-12));
  }
}

TEST_CASE("the fragments of a pixel are what points see in it") {
  constexpr int n = 48;
  for (const Example& example : examples()) {
    CAPTURE(example.name);
    const MadePattern made = made_pattern(example.changes, size);
    const ExactPixels exact(*made.frame);
    for_each_pixel([&](int x, int y) {
      if ((7 * x + 3 * y) % 5 != 0 && (x != size.width / 2 || y != size.height / 2)) return;
      std::vector<SamplePoint> points;
      for (int i = 0; i < n * n; ++i) points.push_back({x + (i % n + 0.5) / n, y + (i / n + 0.5) / n});
      std::map<Element, double> weights;
      double red = 0;
      for (const Hit& hit : traced(*made.frame, points))
        weights[hit.element] += 1.0 / (n * n), red += hit.color.r / (n * n);
      // A part has a border of less than 4 pixels' sides in this one, which crosses fewer than 4 cells of the grid for
      // each of its columns: at most half of each is wrong.
      const auto fragments = exact.fragments(x, y);
      for (const Fragment& f : fragments) {
        CHECK(std::abs(f.weight - weights[f.element]) < 8.0 / n);
        weights.erase(f.element);
      }
      // What points see is recorded.
      CHECK(weights.empty());
      CHECK(std::abs(red - exact.red(x, y)) <
            8.0 / n * static_cast<double>(std::min<std::size_t>(fragments.size(), 4)));
    });
  }
}

TEST_CASE("an edge covers what the clipped half-plane does, at every angle") {
  Numbers numbers;
  for (const double angle : angles) {
    const double offset = numbers.between(-5, 5);
    const MadePattern made =
        made_pattern({{"kind", std::string("edge")}, {"angle_deg", angle}, {"offset", offset}}, size);
    const ExactPixels exact(*made.frame);
    for_each_pixel([&](int x, int y) {
      CAPTURE(angle, offset, x, y);
      const LongPoint middle{size.width / 2.0L, size.height / 2.0L};
      CHECK(std::abs(exact.red(x, y) - static_cast<double>(stripe_area(x, y, middle, angle, offset, 1000))) < 1e-13);
    });
  }
}

TEST_CASE("a grating covers what its clipped stripes do, at every angle and frequency") {
  for (const double angle : angles) {
    for (const double frequency : {0.05, 0.31, 0.8125, 2.9}) {
      for (const double duty : {0.5, 0.1}) {
        const double phase = 77;
        const MadePattern made = made_pattern({{"kind", std::string("grating")},
                                               {"angle_deg", angle},
                                               {"frequency", frequency},
                                               {"duty", duty},
                                               {"phase_deg", phase}},
                                              size);
        const ExactPixels exact(*made.frame);
        for (const auto& [x, y] : {std::pair{0, 0}, {11, 9}, {5, 17}, {22, 3}, {10, 8}}) {
          long double light = 0;
          const int most = static_cast<int>(frequency * 20) + 2;
          for (int k = -most; k <= most; ++k) {
            const long double at = (k - phase / 360.0L) / frequency, half = duty / 2.0L / frequency;
            light += stripe_area(x, y, {size.width / 2.0L, size.height / 2.0L}, angle, at - half, at + half);
          }
          CAPTURE(angle, frequency, duty, x, y);
          CHECK(std::abs(exact.red(x, y) - static_cast<double>(light)) < 1e-12);
        }
      }
    }
  }
}

TEST_CASE("the cells of a checkerboard cover what they do clipped, at every angle and size") {
  for (const double angle : angles) {
    for (const double cell : {0.3, 1.0, 2.7, 40.0}) {
      const MadePattern made = made_pattern(
          {{"kind", std::string("checkerboard")}, {"angle_deg", angle}, {"cell", cell}, {"view.x", 0.4}}, size);
      const ExactPixels exact(*made.frame);
      const long double c = std::cos(turn(angle)), s = std::sin(turn(angle));
      for (const auto& [x, y] : {std::pair{11, 9}, {12, 8}, {15, 17}, {22, 3}, {0, 9}}) {
        const int most = static_cast<int>(20 / cell) + 1;
        long double light = 0;
        for (int i = -most; i < most; ++i) {
          for (int j = -most; j < most; ++j) {
            if ((i + j) % 2 != 0) continue;
            LongPolygon corners;
            for (const auto& [u, v] : {std::pair{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}})
              corners.push_back(
                  {size.width / 2.0L + 0.4 + cell * (c * u - s * v), size.height / 2.0L + cell * (s * u + c * v)});
            light += common_area(pixel_square(x, y), corners);
          }
        }
        CAPTURE(angle, cell, x, y);
        CHECK(std::abs(exact.red(x, y) - static_cast<double>(light)) < 1e-12);
      }
    }
  }
}

TEST_CASE("the wedges of a star cover what they do clipped, at its middle and elsewhere") {
  for (const int spokes : {2, 3, 8, 50}) {
    for (const double view : {0.0, 0.2, 0.5}) {
      const double angle = 17;
      const MadePattern made = made_pattern(
          {{"kind", std::string("star")}, {"spokes", std::int64_t{spokes}}, {"angle_deg", angle}, {"view.x", view}},
          size);
      const ExactPixels exact(*made.frame);
      const LongPoint middle{size.width / 2.0L + view, size.height / 2.0L};
      for_each_pixel([&](int x, int y) {
        long double light = 0;
        for (int k = 0; k < spokes; ++k) {
          LongPolygon wedge{middle};
          for (int i : {2 * k, 2 * k + 1}) {
            const long double a = turn(angle) + std::numbers::pi_v<long double> * i / spokes;
            wedge.push_back({middle.x + 60 * std::cos(a), middle.y + 60 * std::sin(a)});
          }
          light += common_area(pixel_square(x, y), wedge);
        }
        CAPTURE(spokes, view, x, y);
        CHECK(std::abs(exact.red(x, y) - static_cast<double>(light)) < 1e-12);
      });
    }
  }
}

TEST_CASE("edges, stripes and cells that end on pixels' borders leave pixels of one element") {
  // The image is 24 wide: its middle is a border.
  const Changes patterns[] = {
      {{"kind", std::string("edge")}, {"angle_deg", 0.0}},
      {{"kind", std::string("edge")}, {"angle_deg", 90.0}, {"offset", 2.0}},
      {{"kind", std::string("edge")}, {"angle_deg", -180.0}, {"offset", -3.0}},
      {{"kind", std::string("grating")}, {"frequency", 0.25}, {"phase_deg", 90.0}},
      {{"kind", std::string("grating")}, {"frequency", 0.25}, {"phase_deg", 90.0}, {"angle_deg", 270.0}},
      {{"kind", std::string("checkerboard")}, {"cell", 1.0}},
      {{"kind", std::string("checkerboard")}, {"cell", 4.0}, {"angle_deg", 90.0}}};
  for (const Changes& changes : patterns) {
    const MadePattern made = made_pattern(changes, {24, 16});
    const ExactPixels exact(*made.frame);
    double light = 0;
    for (int y = 0; y < 16; ++y) {
      for (int x = 0; x < 24; ++x) {
        CHECK(exact.fragments(x, y).size() == 1);
        light += exact.red(x, y);
      }
    }
    CHECK(light > 0);
    CHECK(light < 24 * 16);
  }
}

TEST_CASE("a pattern that is moved by whole pixels is the same picture elsewhere") {
  for (const Example& example : examples()) {
    double view_x = 0, view_y = 0;
    for (const auto& [name, value] : example.changes) {
      if (name == "view.x") view_x = std::get<double>(value);
      if (name == "view.y") view_y = std::get<double>(value);
    }
    CAPTURE(example.name);
    const MadePattern made = made_pattern(example.changes, size);
    const MadePattern moved =
        made_pattern(with(example.changes, {{"view.x", view_x + 3}, {"view.y", view_y - 2}}), size);
    const ExactPixels exact(*made.frame), other(*moved.frame);
    for_each_pixel([&](int x, int y) {
      if (x + 3 >= size.width || y < 2) return;
      CAPTURE(x, y);
      CHECK(std::abs(exact.red(x, y) - other.red(x + 3, y - 2)) < 1e-7);
    });
  }
}

TEST_CASE("waves are their mean and the sum of the sinusoids that the frame names") {
  for (const Changes& changes :
       {Changes{{"kind", std::string("sinusoids")}, {"view.x", 0.7}}, Changes{{"kind", std::string("wave")},
                                                                              {"frequency", 0.8125},
                                                                              {"angle_deg", 30.0},
                                                                              {"phase_deg", 50.0},
                                                                              {"second_amplitude", 0.2}}}) {
    const MadePattern made = made_pattern(changes, {32, 31});
    const ExactPixels exact(*made.frame);
    const auto value = [&](double x, double y, bool averaged) {
      double sum = 0.5;
      for (const Sinusoid& s : made.frame->spectrum()->sinusoids()) {
        const auto sinc = [](double f) { return f == 0 ? 1 : std::sin(std::numbers::pi * f) / (std::numbers::pi * f); };
        sum += s.amplitude * (averaged ? sinc(s.fx) * sinc(s.fy) : 1) *
               std::cos(2 * std::numbers::pi * (s.fx * x + s.fy * y) + s.phase);
      }
      return sum;
    };
    Numbers numbers;
    for (int k = 0; k < 200; ++k) {
      const double x = numbers.between(-1, 33), y = numbers.between(-1, 32);
      CAPTURE(k, x, y);
      // Of floats.
      CHECK(std::abs(traced(*made.frame, {{x, y}})[0].color.r - value(x, y, false)) < 1e-7);
      const int i = k % 32, j = k % 31;
      CHECK(std::abs(exact.red(i, j) - value(i + 0.5, j + 0.5, true)) < 1e-7);
    }
  }
}

TEST_CASE("a wave has its phase in the middle of the picture, and goes on in its direction") {
  const MadePattern made =
      made_pattern({{"kind", std::string("wave")}, {"frequency", 0.125}, {"angle_deg", 90.0}}, {16, 16});
  const auto hits = traced(*made.frame, {{8, 8}, {3, 8}, {8, 10}, {8, 12}, {8, 6}});
  const float expected[] = {1, 1, 0.5F, 0, 0.5F};
  for (std::size_t k = 0; k < 5; ++k) CHECK(std::abs(hits[k].color.r - expected[k]) < 1e-7F);
}

TEST_CASE("a zone plate names its local frequency: the rate of its phase") {
  const MadePattern made = made_pattern({{"peak_frequency", 1.25}, {"amplitude", 0.25}}, {40, 20});
  const Spectrum& spectrum = *made.frame->spectrum();
  CHECK(spectrum.sinusoids().empty());
  CHECK(spectrum.amplitude() == 0.25);
  CHECK(spectrum.local_frequency({20, 10}) == 0);
  CHECK(std::abs(spectrum.local_frequency({40, 10}) - 1.25) < 1e-15);
  CHECK(std::abs(spectrum.local_frequency({20, 0}) - 0.625) < 1e-15);
  CHECK(std::abs(spectrum.local_frequency({22, 15}) - 0.3125) < 1e-15);
  // The phase at distance d is the integral of the frequency: at 8 pixels, where it is .5, two cycles.
  const auto hits = traced(*made.frame, {{20, 10}, {28, 10}, {20, 18}, {20 + std::sqrt(8.0), 10}});
  for (std::size_t k = 0; k < 3; ++k) CHECK(std::abs(hits[k].color.r - 0.75F) < 1e-6F);
  CHECK(std::abs(hits[3].color.r - 0.5F) < 1e-6F);
}

TEST_CASE("patterns answer what they have, and refuse tiles that they do not have") {
  const ScenePlugin& plugin = scene_plugin("pattern");
  const auto settings = [&](const Changes& changes) { return changed(plugin.parameters, changes); };
  using enum Questions;
  CHECK(plugin.answers(settings({})) == (points | averages | filtered_averages | spectrum));
  CHECK(plugin.answers(settings({{"kind", std::string("edge")}})) == (points | averages | filtered_averages));
  CHECK(plugin.answers(settings({{"kind", std::string("edge")}, {"tile", std::int64_t{1}}})) == (points | averages));
  CHECK(plugin.problem(settings({})) == "");
  CHECK(plugin.problem(settings({{"tile", std::int64_t{2}}})) ==
        "tile is for edge, disk and blob; a zone_plate has none: 0");
  CHECK(plugin.problem(settings({{"kind", std::string("edge")}, {"angles", std::string("any")}})) ==
        "angles of \"any\" are those of tiles, of which there are none (tile is 0); 1 or more");
}

TEST_CASE("degenerate patterns are plain: no period, no light, no dark") {
  const auto reds = [](const Changes& changes) {
    const MadePattern made = made_pattern(changes, size);
    const ExactPixels exact(*made.frame);
    std::set<double> all;
    for_each_pixel([&](int x, int y) { all.insert(exact.red(x, y)); });
    return all;
  };
  const std::pair<std::string, Value> grating{"kind", std::string("grating")},
      sinusoids{"kind", std::string("sinusoids")};
  CHECK(reds({grating, {"frequency", 0.0}}) == std::set{1.0});
  CHECK(reds({grating, {"frequency", 0.0}, {"phase_deg", 180.0}}) == std::set{0.0});
  CHECK(reds({grating, {"duty", 0.0}}) == std::set{0.0});
  CHECK(reds({sinusoids, {"components_in", std::int64_t{0}}, {"components_out", std::int64_t{0}}}) == std::set{0.5});
  // The whole star in one point, which is seen as well.
  const MadePattern star = made_pattern({{"kind", std::string("star")}}, {24, 18});
  CHECK(traced(*star.frame, {{12, 9}})[0].element != background);
}

}  // namespace moire::test
