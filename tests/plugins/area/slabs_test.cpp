// Visible areas where curves meet, against visible lengths integrated in extended precision.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "exact/curves/shape.h"
#include "hard_curves.h"
#include "sanitized.h"
#include "support/curve_oracle.h"

namespace moire::test {
namespace {

// Of each curve, which come from back to front, and the background.
std::vector<double> found(const HardCurves& pixel) {
  area::Slabs slabs;
  std::uint32_t layer = 0;
  for (auto curve = pixel.curves.rbegin(); curve != pixel.curves.rend(); ++curve, ++layer) {
    const area::Shape shape = std::visit([](const auto& c) { return area::Shape(c); }, *curve);
    if (!shape.is_empty()) shape.cover(pixel.x, pixel.y, layer, slabs);
  }
  std::vector<double> areas = slabs.integrate(layer);
  std::reverse(areas.begin(), areas.end() - 1);
  return areas;
}

// A boundary is where it should be within some 2^-52 of the pixel; where others are nearer than that in front of it,
// as much is given to the wrong one of them.
double bound(const HardCurves& pixel) { return 1e-14 * static_cast<double>(pixel.curves.size() + 2); }

}  // namespace

TEST_CASE("each curve gets its exact visible area in hard pixels, and a pixel's areas sum to 1") {
  for (const std::string_view kind : hard_curve_kinds()) {
    const bool is_large = kind == "forty of them" || kind == "a fan of thirty lines";
    for (std::uint64_t seed = 1; seed <= (is_large ? (sanitized ? 1 : 2) : (sanitized ? 2 : 40)); ++seed) {
      const HardCurves pixel = hard_curves(kind, seed);
      const std::vector<double> areas = found(pixel), truth = visible_areas(pixel.curves, pixel.x, pixel.y);
      double error = 0, sum = 0;
      for (std::size_t k = 0; k < truth.size(); ++k) {
        error = std::max(error, std::abs(areas[k] - truth[k]));
        sum += areas[k];
      }
      CAPTURE(kind, seed, error, sum - 1);
      CHECK(error <= bound(pixel));
      CHECK(std::abs(sum - 1) <= 1e-12);
      CHECK(*std::min_element(areas.begin(), areas.end()) >= -1e-15);
    }
  }
}

}  // namespace moire::test
