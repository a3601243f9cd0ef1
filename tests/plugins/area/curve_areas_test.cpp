// Whole images of lines and circles by the exact area sampler.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <map>
#include <numbers>

#include <fmt/format.h>

#include "exact/curves/curve_areas.h"
#include "hard_curves.h"
#include "sanitized.h"
#include "support/curve_frame.h"
#include "support/curve_oracle.h"
#include "support/hard_pixels/sketch.h"
#include "support/plugins.h"
#include "support/polygon_frame.h"

namespace moire::test {
namespace {

Rendered exact(const Frame& frame, Manner manner = {}) { return rendered(area::CurveAreas(frame), frame, manner); }

std::unique_ptr<Sampler> plugin(const char* integrator) {
  return sampler("area", {{"method", std::string("exact")}, {"integrator", std::string(integrator)}});
}

// By element, the last for the background.
std::vector<double> weights(const Content& content, std::size_t elements) {
  std::vector<double> result(elements + 1);
  for (const Fragment& f : content.fragments) result[f.element == background ? elements : f.element - 1] += f.weight;
  return result;
}

// Many of all kinds and sizes, element k + 1 the k-th from the back.
std::vector<Curve> drawing(std::uint64_t seed, int count, double side) {
  hard::Chance chance(seed);
  std::vector<Curve> curves;
  for (int k = 0; k < count; ++k) {
    const Color color{static_cast<float>(chance.unit()), static_cast<float>(chance.unit()),
                      static_cast<float>(chance.unit())};
    const auto element = static_cast<Element>(k + 1);
    const double width = chance.one_in(4) ? chance.between(2, 8) : chance.between(0.2, 1.5);
    if (chance.one_in(2)) {
      curves.push_back(LineCurve{element, color, chance.point(-5, side + 5), chance.point(-5, side + 5), width,
                                 static_cast<Cap>(chance.whole(0, 2))});
    } else {
      curves.push_back(CircleCurve{element, color, chance.point(-5, side + 5), chance.between(0, side / 2), width});
    }
  }
  return curves;
}

// As polygons with circles of so many corners, front to back.
std::vector<FlatPolygon> chorded(const std::vector<Curve>& curves, int corners) {
  std::vector<FlatPolygon> polygons;
  const auto circle = [&](Point center, double radius, bool is_hole) {
    std::vector<Point> contour;
    for (int k = 0; k < corners; ++k) {
      const double angle = (is_hole ? -2 : 2) * std::numbers::pi * k / corners;
      contour.push_back({center.x + radius * std::cos(angle), center.y + radius * std::sin(angle)});
    }
    return contour;
  };
  for (auto curve = curves.rbegin(); curve != curves.rend(); ++curve) {
    if (const auto* line = std::get_if<LineCurve>(&*curve)) {
      const double dx = line->to.x - line->from.x, dy = line->to.y - line->from.y;
      const double half = line->width / 2, length = std::hypot(dx, dy), x = half * dx / length, y = half * dy / length;
      const double out = line->cap == Cap::square ? 1 : 0;
      std::vector<std::vector<Point>> contours{{{line->from.x - out * x - y, line->from.y - out * y + x},
                                                {line->from.x - out * x + y, line->from.y - out * y - x},
                                                {line->to.x + out * x + y, line->to.y + out * y - x},
                                                {line->to.x + out * x - y, line->to.y + out * y + x}}};
      if (line->cap == Cap::round) {
        for (const Point end : {line->from, line->to}) contours.push_back(circle(end, half, false));
      }
      polygons.push_back({line->element, line->color, FillRule::nonzero, contours});
    } else {
      const auto& ring = std::get<CircleCurve>(*curve);
      std::vector<std::vector<Point>> contours{circle(ring.center, ring.radius + ring.width / 2, false)};
      if (ring.radius > ring.width / 2) contours.push_back(circle(ring.center, ring.radius - ring.width / 2, true));
      polygons.push_back({ring.element, ring.color, FillRule::nonzero, contours});
    }
  }
  return polygons;
}

}  // namespace

TEST_CASE("images of curves have their exact areas in hard pixels, and weights that sum to 1") {
  for (const std::string_view kind : hard_curve_kinds()) {
    for (std::uint64_t seed = 101; seed <= (sanitized ? 101 : 102); ++seed) {
      const HardCurves pixel = hard_curves(kind, seed);
      const std::vector<double> truth = visible_areas(pixel.curves, pixel.x, pixel.y);
      const Rendered image = exact(CurveFrame({12, 12}, pixel.curves));
      const std::vector<double> found = weights(image.at(pixel.x, pixel.y), pixel.curves.size());
      double error = 0, sum_error = 0, least = 1;
      for (std::size_t k = 0; k < truth.size(); ++k) error = std::max(error, std::abs(found[k] - truth[k]));
      for (const Content& content : image.pixels) {
        sum_error = std::max(sum_error, std::abs(content.weight - 1));
        for (const Fragment& f : content.fragments) least = std::min(least, f.weight);
      }
      CAPTURE(kind, seed, error, sum_error, least);
      CHECK(error <= 1e-14 * static_cast<double>(pixel.curves.size() + 2));
      CHECK(sum_error <= 1e-12);
      CHECK(least > 0);
    }
  }
}

// A chord's polygon leaves out a strip along its circle that is r (1 - cos(pi / n)) wide at the most and, within a
// pixel, shorter than the pixel's outline. What an element shows is off by no more than the strips of all that are seen
// there, each of which has two circles.
TEST_CASE("images of curves agree with the sweep over polygons of ever more corners") {
  constexpr int side = 40, count = 30;
  for (std::uint64_t seed = 1; seed <= (sanitized ? 1 : 3); ++seed) {
    const std::vector<Curve> curves = drawing(seed, count, side);
    const Rendered image = exact(CurveFrame({side, side}, curves));
    for (const int corners : {256, 4096}) {
      const Rendered polygons = rendered(*plugin("sweep"), PolygonFrame({side, side}, chorded(curves, corners)));
      const double sagitta = (side / 2.0 + 4) * (1 - std::cos(std::numbers::pi / corners));
      double worst = 0;  // as a share of what is allowed
      for (std::size_t p = 0; p < image.pixels.size(); ++p) {
        const auto one = weights(image.pixels[p], count), other = weights(polygons.pixels[p], count);
        double seen = 0, error = 0;
        for (std::size_t k = 0; k < one.size(); ++k) {
          seen += one[k] > 0 || other[k] > 0 ? 1 : 0;
          error = std::max(error, std::abs(one[k] - other[k]));
        }
        worst = std::max(worst, error / (seen * 2 * 4 * sagitta + 1e-12));
      }
      CAPTURE(seed, corners, worst);
      CHECK(worst <= 1);
      CHECK(worst > 0.01);
    }
  }
}

TEST_CASE("images of curves are the same to the bit in all blocks and threads, recorded or not") {
  const CurveFrame frame({71, 53}, drawing(9, 60, 70), {.1F, .2F, .3F});
  const Rendered image = exact(frame);
  for (const int threads : {1, 2}) {
    for (const int block_width : {1, 7, 32, 71}) {
      for (const bool recording : {true, false}) {
        for (const Blocks order : {Blocks::rows, Blocks::columns}) {
          CAPTURE(threads, block_width, recording);
          const Rendered other = exact(frame, {threads, block_width, recording, order});
          CHECK(first_difference(image, other) == "");
          CHECK(other.counters == image.counters);
        }
      }
    }
  }
}

TEST_CASE("a pixel that no curve touches has its background, one that a curve covers has nothing else") {
  const CurveFrame frame({6, 3}, {LineCurve{7, {1, 0, 0}, {1, 1.5}, {5, 1.5}, 1}}, {0, 0, 1});
  const Rendered image = exact(frame);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 6; ++x) {
      const std::vector<Fragment>& fragments = image.at(x, y).fragments;
      REQUIRE(fragments.size() == 1);
      const bool is_on_line = y == 1 && x >= 1 && x < 5;
      CHECK(fragments[0].element == (is_on_line ? 7 : background));
      CHECK(fragments[0].weight == 1);
      CHECK(fragments[0].color == (is_on_line ? Color{1, 0, 0} : Color{0, 0, 1}));
    }
  }
}

TEST_CASE("curves that cover no area leave the background alone") {
  std::vector<Curve> curves{LineCurve{1, {}, {2, 2}, {2, 2}, 1},
                            LineCurve{2, {}, {0, 1}, {5, 2}, 0},
                            LineCurve{3, {}, {2, 2}, {2, 2}, 0, Cap::round},
                            CircleCurve{4, {}, {2, 2}, 1, 0},
                            CircleCurve{5, {}, {2, 2}, 0, 0},
                            CircleCurve{6, {}, {1e300, 0}, 3, 1},
                            LineCurve{7, {}, {1e300, 0}, {1e300, 5}, 1, Cap::round}};
  const CurveFrame frame({4, 4}, curves);
  for (const Content& pixel : exact(frame).pixels) {
    REQUIRE(pixel.fragments.size() == 1);
    CHECK(pixel.fragments[0].element == background);
  }
  for (const Content& pixel : exact(CurveFrame({4, 4}, {})).pixels) CHECK(pixel.weight == 1);
}

TEST_CASE("the exact area sampler takes curves by itself where a frame has them, and polygons where it has none") {
  const CurveFrame curves({20, 20}, drawing(3, 12, 20));
  CHECK(first_difference(rendered(*plugin("auto"), curves), exact(curves)) == "");
  const PolygonFrame polygons({20, 20}, chorded(drawing(3, 12, 20), 50));
  CHECK(first_difference(rendered(*plugin("auto"), polygons), rendered(*plugin("sweep"), polygons)) == "");
}

}  // namespace moire::test
