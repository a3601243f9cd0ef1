// What Catmull 1978 (doi:10.1145/800248.807360) shows and says of area sampling, as cases known on paper.
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "support/plugins.h"
#include "support/polygon_frame.h"

namespace moire::test {
namespace {

constexpr std::array integrators{"sweep", "prepared", "catmull"};
constexpr Color black{}, white{1, 1, 1};

std::unique_ptr<Sampler> exact(const char* integrator, bool jagged = false) {
  return sampler("area",
                 {{"method", std::string("exact")}, {"integrator", std::string(integrator)}, {"jagged", jagged}});
}

FlatPolygon polygon(Element element, Color color, std::vector<Point> corners) {
  return {element, color, FillRule::nonzero, {std::move(corners)}};
}

std::map<Element, double> weights(const Content& pixel) {
  std::map<Element, double> result;
  for (const Fragment& f : pixel.fragments) result[f.element] += f.weight;
  return result;
}

// Of all pixels, in the precision of fragments.
double sum_of_intensities(const Sampler& sampler, const Frame& frame) {
  double sum = 0;
  for (const Content& pixel : rendered(sampler, frame).pixels) {
    for (const Fragment& f : pixel.fragments) sum += f.weight * f.color.g;
  }
  return sum;
}

// White pickets on black, `gap` pixels from one to the next.
PolygonFrame picket_fence(double left, double width, double gap, int pickets) {
  std::vector<FlatPolygon> fence;
  for (int k = 0; k < pickets; ++k) {
    const double x = left + k * gap;
    fence.push_back(polygon(static_cast<Element>(k + 1), white,
                            {{x, 2.25}, {x + width / 2, 1.75}, {x + width, 2.25}, {x + width, 8.5}, {x, 8.5}}));
  }
  return {{40, 10}, std::move(fence), black};
}

// A white line on black about the image's middle.
PolygonFrame thin_line(double length, double width, double angle) {
  constexpr ImageSize size{32, 32};
  const Point along{std::cos(angle) * length / 2, std::sin(angle) * length / 2};
  const Point across{-std::sin(angle) * width / 2, std::cos(angle) * width / 2};
  const auto corner = [&](int a, int b) -> Point {
    return {16.1 + a * along.x + b * across.x, 15.8 + a * along.y + b * across.y};
  };
  return {size, {polygon(1, white, {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)})}, black};
}

}  // namespace

TEST_CASE("Catmull's Fig. 1: a quarter green, a quarter black, half blue and no red") {
  // Green and black hide the pixel's left half together, blue its right half; red lies behind all their joints.
  const PolygonFrame frame({1, 1}, {polygon(1, {0, 1, 0}, {{-1, -1}, {.5, -1}, {.5, .5}, {-1, .5}}),
                                    polygon(2, black, {{-1, .5}, {.5, .5}, {.5, 2}, {-1, 2}}),
                                    polygon(3, {0, 0, 1}, {{.5, -1}, {2, -1}, {2, 2}, {.5, 2}}),
                                    polygon(4, {1, 0, 0}, {{.25, -1}, {.875, -1}, {.75, 2}, {.125, 2}})});
  for (const char* integrator : integrators) {
    CAPTURE(integrator);
    const Content pixel = rendered(*exact(integrator), frame).at(0, 0);
    CHECK(weights(pixel) == std::map<Element, double>{{1, .25}, {2, .25}, {3, .5}});
    CHECK(pixel.color == Color{0, .25F, .5F});
  }
}

TEST_CASE("Catmull's Fig. 6: of four polygons in a pixel three are seen") {
  // A and B meet along x = 1/2; C lies across their boundary and covers the pixel's lower half; D is behind C.
  const PolygonFrame frame({1, 1}, {polygon(3, white, {{-1, .5}, {2, .5}, {2, 3}, {-1, 3}}),
                                    polygon(4, white, {{.125, .5}, {.875, .625}, {.5, .875}}),
                                    polygon(1, white, {{-3, -3}, {.5, -3}, {.5, 3}, {-3, 3}}),
                                    polygon(2, white, {{.5, -3}, {3, -3}, {3, 3}, {.5, 3}})});
  for (const char* integrator : integrators) {
    CAPTURE(integrator);
    CHECK(weights(rendered(*exact(integrator), frame).at(0, 0)) ==
          std::map<Element, double>{{1, .25}, {2, .25}, {3, .5}});
  }
}

TEST_CASE("the intensities of a picket fence that moves have a constant sum by area, not by points") {
  // One picket a pixel: all or nothing for a point at the pixel's middle.
  constexpr double width = 0.4;
  constexpr int pickets = 25;
  // Each is a rectangle of 6.25 pixels' height and a triangle of half a pixel's.
  constexpr double area = pickets * width * (6.25 + 0.25);
  bool all_seen = false, none_seen = false;
  for (int step = 0; step < 16; ++step) {
    const PolygonFrame frame = picket_fence(3.03 + step / 16.0, width, 1, pickets);
    CAPTURE(step);
    for (const char* integrator : integrators) {
      CAPTURE(integrator);
      CHECK(std::abs(sum_of_intensities(*exact(integrator), frame) - area) <= 400 * 1e-12);
    }
    const double points = sum_of_intensities(*sampler("point"), frame);
    if (points == 0) none_seen = true;
    // The rows with their middle between 2.25 and 8.5, all white.
    if (points >= pickets * 6.0) all_seen = true;
  }
  CHECK(all_seen);
  CHECK(none_seen);
}

TEST_CASE("the intensities of a thin line that turns have a constant sum by area, not by points") {
  constexpr double length = 25, width = 0.01;
  double least = length, most = 0;
  for (int degree = 0; degree < 180; degree += 5) {
    const PolygonFrame frame = thin_line(length, width, degree * std::numbers::pi / 180);
    CAPTURE(degree);
    for (const char* integrator : integrators) {
      CAPTURE(integrator);
      // The line's corners are rounded to 2^-48 pixels, times its length on both sides.
      CHECK(std::abs(sum_of_intensities(*exact(integrator), frame) - length * width) <=
            2 * length * 0x1p-48 + 1024 * 1e-14);
    }
    const double points = sum_of_intensities(*sampler("point"), frame);
    least = std::min(least, points), most = std::max(most, points);
  }
  // Most turns are not seen at all.
  CHECK(least == 0);
  CHECK(most >= 1);
}

TEST_CASE("a visible piece of one millionth of the screen has its share of the intensities") {
  // Between two black polygons that all but hide it, a white one is seen as a triangle in the corner of four pixels.
  constexpr ImageSize size{64, 48};
  constexpr double share = 1e-6, area = share * size.width * size.height;
  const double leg = std::sqrt(2 * area);
  const Point corner{33 - leg / 3, 20 - leg / 3};
  const double right = corner.x + leg, low = corner.y + leg;
  const PolygonFrame frame(
      size, {polygon(1, black, {{0, 0}, {64, 0}, {64, corner.y}, {corner.x, corner.y}, {corner.x, 48}, {0, 48}}),
             polygon(2, black, {{64, corner.y}, {right, corner.y}, {corner.x, low}, {corner.x, 48}, {64, 48}}),
             polygon(3, white, {{10, 10}, {50, 10}, {50, 40}, {10, 40}})});
  for (const char* integrator : integrators) {
    CAPTURE(integrator);
    const Rendered image = rendered(*exact(integrator), frame);
    std::map<Element, double> all;
    for (const Content& pixel : image.pixels) {
      for (const auto& [element, weight] : weights(pixel)) all[element] += weight;
    }
    // Corners are rounded to 2^-48 at most, over the length of the legs.
    CHECK(std::abs(all[3] - area) <= 1e-12);
    CHECK(all[background] <= 1e-12);
    // What the screen's brightness is made of.
    CHECK(std::abs(sum_of_intensities(*exact(integrator), frame) / (size.width * size.height) - share) <= 1e-15);
  }
}

TEST_CASE("jagged images are what the sampler point sees") {
  constexpr ImageSize size{24, 18};
  for (unsigned seed = 1; seed <= 100; ++seed) {
    std::mt19937 random(seed);
    const auto unit = [&] { return static_cast<double>(random()) * 0x1p-32; };
    std::vector<FlatPolygon> polygons;
    for (unsigned k = 1; k <= 1 + seed / 4; ++k) {
      const Color color{static_cast<float>(unit()), static_cast<float>(unit()), static_cast<float>(unit())};
      FlatPolygon& polygon =
          polygons.emplace_back(FlatPolygon{k, color, k % 2 == 0 ? FillRule::nonzero : FillRule::even_odd, {}});
      for (int contours = 1 + static_cast<int>(unit() * 3); contours > 0; --contours) {
        auto& contour = polygon.contours.emplace_back();
        for (int corners = 3 + static_cast<int>(unit() * 6); corners > 0; --corners) {
          const double x = (unit() * 1.5 - 0.25) * size.width;
          contour.push_back({x, (unit() * 1.5 - 0.25) * size.height});
        }
      }
    }
    const PolygonFrame frame(size, std::move(polygons), {.25F, .5F, 1});
    CAPTURE(seed);
    CHECK(first_difference(rendered(*exact("catmull", true), frame), rendered(*sampler("point"), frame)) == "");
  }
}

}  // namespace moire::test
