// `area` with `method: exact`: its three integrators against each other and against many points.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <random>

#include "support/plugins.h"
#include "support/polygon_frame.h"

namespace moire::test {
namespace {

std::unique_ptr<Sampler> exact(const std::string& integrator) {
  return sampler("area", {{"method", std::string("exact")}, {"integrator", integrator}});
}

// Overlapping polygons of few corners in any order, so that most cross themselves and each other.
std::vector<FlatPolygon> tangle(unsigned seed, int polygons, double width, double height) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<FlatPolygon> result;
  for (int k = 0; k < polygons; ++k) {
    FlatPolygon polygon{
        static_cast<Element>(k + 1),
        {static_cast<float>(unit(random)), static_cast<float>(unit(random)), static_cast<float>(unit(random))},
        k % 2 == 0 ? FillRule::nonzero : FillRule::even_odd,
        {}};
    const int contours = 1 + k % 3;
    const double reach = k % 5 == 0 ? 1.5 : 0.5, x = unit(random) * width, y = unit(random) * height;
    for (int c = 0; c < contours; ++c) {
      auto& contour = polygon.contours.emplace_back();
      const int corners = 3 + static_cast<int>(unit(random) * 5);
      for (int i = 0; i < corners; ++i)
        contour.push_back({x + (unit(random) - 0.5) * reach * width, y + (unit(random) - 0.5) * reach * height});
      // Level and upright edges, and corners on pixel corners.
      if (k % 4 == 0) {
        for (Point& p : contour) p = {std::round(p.x * 2) / 2, std::round(p.y * 2) / 2};
      }
    }
    result.push_back(std::move(polygon));
  }
  return result;
}

double largest_difference(const Rendered& one, const Rendered& other) {
  double largest = 0;
  for (std::size_t k = 0; k < one.pixels.size(); ++k) {
    const Color a = one.pixels[k].color, b = other.pixels[k].color;
    for (const float d : {a.r - b.r, a.g - b.g, a.b - b.b}) largest = std::max<double>(largest, std::abs(d));
  }
  return largest;
}

}  // namespace

TEST_CASE("the three exact integrators agree on polygons that cross themselves and each other") {
  for (unsigned seed = 1; seed <= 400; ++seed) {
    const ImageSize size{23, 19};
    const PolygonFrame frame(size, tangle(seed, 1 + static_cast<int>(seed) / 2, size.width, size.height),
                             {.25F, .5F, 1});
    const Rendered sweep = rendered(*exact("sweep"), frame);
    const Rendered prepared = rendered(*exact("prepared"), frame);
    const Rendered catmull = rendered(*exact("catmull"), frame);
    CAPTURE(seed);
    // Colours are kept as floats.
    CHECK(largest_difference(sweep, catmull) <= 0x1p-23);
    CHECK(largest_difference(sweep, prepared) <= 0x1p-23);
  }
}

TEST_CASE("exact pixels are what ever more points come to") {
  const ImageSize size{16, 12};
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const PolygonFrame frame(size, tangle(seed, 6, size.width, size.height), {.25F, .5F, 1});
    const Rendered area = rendered(*exact("sweep"), frame);
    constexpr int n = 64;
    const Rendered points =
        rendered(*sampler("supersample", {{"n", std::int64_t{n}}, {"layout", std::string("grid")}}), frame);
    CAPTURE(seed);
    // Each edge that crosses a pixel puts at most some 2 n of the n x n points on the wrong side, half of them on
    // average.
    CHECK(largest_difference(area, points) <= 12.0 / n);
    double sum = 0;
    for (std::size_t k = 0; k < area.pixels.size(); ++k) sum += area.pixels[k].color.g - points.pixels[k].color.g;
    CHECK(std::abs(sum) / static_cast<double>(area.pixels.size()) <= 0.5 / n);
  }
}

}  // namespace moire::test
