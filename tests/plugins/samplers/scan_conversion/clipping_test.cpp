// Drawing into a part of the image puts the pixels that drawing into all of it puts there, and no other.
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "kernels.h"
#include "sanitized.h"

namespace moire::test {
namespace {

using namespace scan_conversion;

PixelArea random_part(Numbers& numbers, const PixelArea& area) {
  const auto width = static_cast<int>(numbers.integer(1, area.width)),
             height = static_cast<int>(numbers.integer(1, area.height));
  return {area.x0 + static_cast<int>(numbers.integer(0, area.width - width)),
          area.y0 + static_cast<int>(numbers.integer(0, area.height - height)), width, height};
}

// Compares a part with the whole.
template <class Draw>
void check_part(const Picture& whole, const PixelArea& part, Draw draw) {
  Picture picture(part);
  draw(part, picture);
  CHECK(picture.again == 0);
  CHECK(picture.outside == 0);
  CHECK(whole.differences(picture) == 0);
}

}  // namespace

TEST_CASE("lines clipped to a part of the image are a part of the picture, by all methods") {
  const PixelArea area{-100, -100, 300, 260};
  Numbers numbers(1);
  for (const LineKernel& kernel : line_kernels()) {
    CAPTURE(kernel.name);
    for (int k = 0; k < (sanitized ? 20 : 250); ++k) {
      const auto end = [&] { return Point{numbers.real(-95, 195), numbers.real(-95, 155)}; };
      const Point from = end(), to = k % 10 == 0 ? Point{from.x + numbers.real(-3, 3), from.y} : end();
      CAPTURE(from.x, from.y, to.x, to.y);
      Picture whole_picture(area);
      kernel.draw(from, to, area, whole_picture);
      CHECK(whole_picture.again == 0);
      for (int part = 0; part < 4; ++part) {
        check_part(whole_picture, random_part(numbers, area),
                   [&](const PixelArea& a, Picture& picture) { kernel.draw(from, to, a, picture); });
      }
    }
  }
}

TEST_CASE("circles clipped to a part of the image are a part of the picture, by all methods") {
  const PixelArea area{-100, -100, 300, 260};
  Numbers numbers(2);
  for (const CircleKernel& kernel : circle_kernels()) {
    CAPTURE(kernel.name);
    for (int k = 0; k < (sanitized ? 10 : 150); ++k) {
      const Point center{numbers.real(-90, 190), numbers.real(-90, 150)};
      const double radius = k % 2 == 0 ? numbers.real(3, 20) : numbers.real(3, 250);
      CAPTURE(center.x, center.y, radius);
      Picture whole_picture(area);
      kernel.draw(center, radius, area, whole_picture);
      CHECK(whole_picture.again == 0);
      CHECK(whole_picture.outside == 0);
      for (int part = 0; part < 4; ++part) {
        check_part(whole_picture, random_part(numbers, area),
                   [&](const PixelArea& a, Picture& picture) { kernel.draw(center, radius, a, picture); });
      }
    }
  }
}

TEST_CASE("two-point lines whose ends are 10^5 to 10^8 pixels away are exact inside the image") {
  const PixelArea area{0, 0, 200, 150};
  Numbers numbers(3);
  int seen = 0;
  for (int k = 0; k < 300; ++k) {
    const std::int64_t far = k % 3 == 0 ? 100'000 : k % 3 == 1 ? 10'000'000 : 100'000'000;
    // Through a pixel of the image, or nearly.
    const PixelIndex from{-numbers.integer(far / 2, far), numbers.integer(-far / 3, far / 3)};
    const std::int64_t times = numbers.integer(2, 3);
    const PixelIndex to{from.x + times * (numbers.integer(0, 199) - from.x), from.y + times * (75 - from.y)};
    const Octant octant = octant_of(from, to);
    if (octant.column.x == 0) continue;
    for (const LineMethod method : {LineMethod::accumulator, LineMethod::direct}) {
      Picture picture(area);
      two_point_line({.method = method, .both_ends = false}, from, to, area, picture);
      picture.for_each_pixel([&](int x, int y) {
        // 2^8 f in whole numbers, from row `from.y` in the line's direction.
        const SignedWide i = x - from.x;
        const SignedWide level = (SignedWide{256} * i * octant.rise) / octant.columns;
        const auto row = static_cast<std::int64_t>(level >> 8);
        const auto upper = static_cast<std::uint32_t>(level & 255);
        const std::int64_t v = (y - from.y) * octant.row.y;
        const std::uint32_t expected = v == row ? 255 - upper : v == row + 1 ? upper : 0;
        // Products beyond 2^53 are no longer whole in doubles: a level is 1 / 256 of a pixel.
        const std::uint32_t tolerance = method == LineMethod::direct && far > 10'000'000 ? 1 : 0;
        const std::uint32_t drawn = picture.at(x, y);
        const std::uint32_t off = drawn > expected ? drawn - expected : expected - drawn;
        if (off > tolerance) FAIL_CHECK(x << ", " << y << ": " << drawn << " for " << expected);
      });
      seen += picture.sum > 0 ? 1 : 0;
    }
  }
  CHECK(seen > 100);
}

TEST_CASE("lines to the ends of numbers are cut, and stay the lines they are") {
  const PixelArea area{0, 0, 64, 64};
  for (const double far : {0x1p40, 1e13, 1e30, 1e308}) {
    CAPTURE(far);
    // Past (32, 32), in steps of 5 columns and 2 rows.
    const Point from{32.5 - far, 32.5 - 0.4 * far}, to{32.5 + far, 32.5 + 0.4 * far};
    const auto ends = within_reach(from, to);
    REQUIRE(ends);
    for (const LineKernel& kernel : line_kernels()) {
      CAPTURE(kernel.name);
      Picture picture(area);
      kernel.draw(ends->from, ends->to, area, picture);
      CHECK(picture.again == 0);
      const std::uint64_t full = kernel.name == "bresenham" ? 1 : 255;
      // Where it runs is lost with the last places of numbers so large, from 2^53 / 64 on by whole pixels.
      if (far < 1e15) CHECK(picture.sum >= 60 * full);
    }
  }
  CHECK_FALSE(within_reach({1e300, 0}, {1e301, 5}));
  CHECK_FALSE(within_reach({0, -1e300}, {1e300, -1e299}));
  CHECK(within_reach({0, 0}, {-1e308, 1e308})->to == Point{-0x1p40, 0x1p40});
  CHECK(within_reach({1, 2}, {3, 4})->from == Point{1, 2});
}

TEST_CASE("circles of up to 2^40 pixels are near their definition where they cross the image") {
  const PixelArea area{0, 0, 64, 64};
  for (const double radius : {1e5, 65535.0, 1e7, 1e9, 1e12}) {
    for (const CircleKernel& kernel : circle_kernels()) {
      if (kernel.name.ends_with("table") && radius > 65535) continue;
      CAPTURE(radius, kernel.name);
      const double side = std::floor(radius * 0.6) + 0.5;
      const Point center{side, std::floor(std::sqrt((radius - side) * (radius + side))) + 32.5};
      Picture picture(area);
      kernel.draw(center, radius, area, picture);
      CHECK(picture.again == 0);
      CHECK(picture.sum > 0);
      if (kernel.name == "midpoint") continue;
      double worst = 0;
      picture.for_each_pixel([&](int x, int y) {
        using Real = long double;
        const Real dx = std::abs(x + Real{0.5} - center.x), dy = std::abs(y + Real{0.5} - center.y);
        const Real i = std::max(dx, dy), j = std::min(dx, dy), r = radius;
        const Real distance = std::abs(i - std::sqrt((r - j) * (r + j)));
        // By the cone, straight and across.
        const Real share = kernel.name == "gupta_sproull"
                               ? cone_share(1, static_cast<double>(distance * std::sqrt((r - j) * (r + j)) / r))
                               : std::max(Real{0}, 1 - distance);
        // Three pixels a row leave out some of the cone's rim, at least 1.5 rows off.
        const bool is_left_out =
            kernel.name == "gupta_sproull" && picture.at(x, y) == 0 && share <= cone_share(1, 1.06);
        if (!is_left_out) worst = std::max(worst, std::abs(static_cast<double>(picture.at(x, y) - 255 * share)));
      });
      // A level and its inverse, or half a table's step; numbers of 10^12 have 53 bits,
      // 10^-4 of a pixel each.
      CHECK(worst <= (kernel.name == "gupta_sproull" ? 4 : 1) + 255 * radius * 0x1p-52);
    }
  }
}

}  // namespace moire::test
