// The oracle of exact areas, on figures whose areas are known on paper and against itself on its side.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numeric>

#include "support/hard_pixels.h"
#include "support/rational_area.h"

namespace moire::test {
namespace {

using Contours = std::vector<std::vector<Point>>;

FlatPolygon polygon(Contours contours, FillRule rule = FillRule::nonzero) { return {1, {}, rule, std::move(contours)}; }

using Areas = std::vector<double>;

Areas areas(const std::vector<FlatPolygon>& polygons, int x = 0, int y = 0) { return visible_areas(polygons, x, y); }

const Contours whole{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

}  // namespace

TEST_CASE("the oracle finds areas that are known on paper") {
  CHECK(areas({}) == Areas{1});
  CHECK(areas({polygon(whole)}) == Areas{1, 0});
  CHECK(areas({polygon(whole)}, 1, 0) == Areas{0, 1});
  CHECK(areas({polygon({{{0, 0}, {1, 0}, {0, 1}}})}) == Areas{0.5, 0.5});
  // Of two halves of the pixel that cross, the second keeps a quarter.
  CHECK(areas({polygon({{{0, 0}, {1, 0}, {0, 1}}}), polygon({{{0, 0}, {1, 0}, {1, 1}}})}) == Areas{0.5, 0.25, 0.25});
  // Thirds: x <= 1 - y / 3 within the pixel.
  CHECK(areas({polygon({{{0, 0}, {1, 0}, {0, 3}}})}) == Areas{5.0 / 6, 1.0 / 6});
  // A triangle that leaves the pixel on the right at y = 1/3 and 2/3.
  CHECK(areas({polygon({{{0, 0.5}, {3, 0}, {3, 1}}})}) == Areas{1.0 / 6, 5.0 / 6});
  CHECK(areas({polygon({{{1000, 2}, {1001, 2}, {1000.5, 3}}})}, 1000, 2) == Areas{0.5, 0.5});
}

TEST_CASE("the oracle keeps both fill rules") {
  const Contours twice{whole[0], whole[0]};
  const Contours there_and_back{whole[0], {{0, 1}, {1, 1}, {1, 0}, {0, 0}}};
  CHECK(areas({polygon(twice, FillRule::nonzero)}) == Areas{1, 0});
  CHECK(areas({polygon(twice, FillRule::even_odd)}) == Areas{0, 1});
  CHECK(areas({polygon(there_and_back, FillRule::nonzero)}) == Areas{0, 1});
  CHECK(areas({polygon(there_and_back, FillRule::even_odd)}) == Areas{0, 1});
  // A square of 3/4 with a hole of 1/4.
  const std::vector<Point> hole{{.25, .25}, {.25, .75}, {.75, .75}, {.75, .25}};
  CHECK(areas({polygon({whole[0], hole}, FillRule::nonzero)}) == Areas{0.75, 0.25});
  // A bow tie winds once this way and once that way; its arms cross at the pixel's middle.
  const Contours bow{{{0, 0}, {1, 1}, {1, 0}, {0, 1}}};
  CHECK(areas({polygon(bow, FillRule::nonzero)}) == Areas{0.5, 0.5});
  CHECK(areas({polygon(bow, FillRule::even_odd)}) == Areas{0.5, 0.5});
  // Two squares of 9/16 in one polygon that overlap in 1/4; one winding number is 2.
  const Contours overlapping{{{0, 0}, {.75, 0}, {.75, .75}, {0, .75}}, {{.25, .25}, {1, .25}, {1, 1}, {.25, 1}}};
  CHECK(areas({polygon(overlapping, FillRule::nonzero)}) == Areas{0.875, 0.125});
  CHECK(areas({polygon(overlapping, FillRule::even_odd)}) == Areas{0.625, 0.375});
}

TEST_CASE("the oracle sees what floating point would lose") {
  // Slivers of 1e-12, in front of and behind a polygon.
  const FlatPolygon sliver = polygon({{{0, 0}, {1, 0}, {1, 0x1p-39}}});
  CHECK(areas({sliver}) == Areas{0x1p-40, 1 - 0x1p-40});
  CHECK(areas({polygon(whole), sliver}) == Areas{1, 0, 0});
  // Two edges that are 2^-100 apart.
  CHECK(areas({polygon({{{0, 0}, {0x1p-100, 0}, {0x1p-100, 1}, {0, 1}}}), polygon(whole)})[0] == 0x1p-100);
  // A line of slope 1 + 2^-20 through points 2^20 away: it enters the pixel at its upper left corner.
  const double far = 0x1p20;
  CHECK(areas({polygon({{{-far, -far - 1}, {far, far + 1}, {-far, far + 1}}})})[0] == 0.5 / (1 + 0x1p-20));
}

TEST_CASE("edges left of the pixel and above it wind") {
  CHECK(areas({polygon({{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}})}) == Areas{1, 0});
  CHECK(areas({polygon({{{-9, -9}, {.5, -9}, {.5, 9}, {-9, 9}}})}) == Areas{0.5, 0.5});
  CHECK(areas({polygon({{{-9, -9}, {-8, -9}, {-8, 9}, {-9, 9}}})}) == Areas{0, 1});
  CHECK(areas({polygon({{{-9, 9}, {9, 9}, {0, -9}}, {{-9, .5}, {9, .5}, {9, 2}, {-9, 2}}}, FillRule::even_odd)}) ==
        Areas{0.5, 0.5});
}

// On its side a drawing is cut into quite other slabs.
TEST_CASE("the oracle finds the same areas in a drawing and in its mirror image about the diagonal") {
  for (const std::string_view kind : hard_pixel_kinds()) {
    for (std::uint64_t seed = 1; seed <= (kind == "a thousand layers" ? 1 : 40); ++seed) {
      CAPTURE(kind, seed);
      const HardPixel pixel = hard_pixel(kind, seed);
      std::vector<FlatPolygon> mirrored = pixel.polygons;
      for (FlatPolygon& polygon : mirrored) {
        for (auto& contour : polygon.contours) {
          for (Point& p : contour) p = {p.y, p.x};
        }
      }
      const Areas one = visible_areas(pixel.polygons, pixel.x, pixel.y);
      const Areas other = visible_areas(mirrored, pixel.y, pixel.x);
      double largest_difference = 0;
      for (std::size_t k = 0; k < one.size(); ++k) {
        largest_difference = std::max(largest_difference, std::abs(one[k] - other[k]));
      }
      CHECK(largest_difference <= 0x1p-52);
      // A rounding of at most 2^-53 in each of the numbers, and in each sum.
      CHECK(std::abs(std::accumulate(one.begin(), one.end(), 0.0) - 1) <= static_cast<double>(one.size()) * 0x1p-52);
    }
  }
}

}  // namespace moire::test
