// Whole circles: no gap, no pixel twice, every pixel as defined.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>

#include "kernels.h"
#include "sanitized.h"

namespace moire::test {
namespace {

using namespace scan_conversion;

PixelArea around(Point center, double radius) {
  const int reach = static_cast<int>(radius) + 4;
  return {static_cast<int>(std::floor(center.x)) - reach, static_cast<int>(std::floor(center.y)) - reach, 2 * reach + 1,
          2 * reach + 1};
}

// The definition: the tent of a pixel's distance in its row, or in its column if it lies nearer to those through the
// centre.
long double tent(Point center, double radius, int x, int y) {
  const long double dx = std::abs(x + 0.5L - center.x), dy = std::abs(y + 0.5L - center.y);
  const long double i = std::max(dx, dy), j = std::min(dx, dy);
  if (j >= radius) return 0;
  return std::max(0.0L, 1 - std::abs(i - std::sqrt((radius - j) * (radius + j))));
}

}  // namespace

TEST_CASE("two-point circles have every pixel of their definition once, and a sum of 4 sqrt(2) r") {
  for (const CircleKernel& kernel : circle_kernels()) {
    if (kernel.name == "midpoint" || kernel.name == "gupta_sproull") continue;
    for (int radius = 3; radius <= 300; radius += sanitized ? 23 : radius < 60 ? 1 : 7) {
      const Point center{7.5, -2.5};
      const PixelArea area = around(center, radius);
      Picture picture(area);
      kernel.draw(center, radius, area, picture);
      double worst = 0;
      picture.for_each_pixel([&](int x, int y) {
        const long double expected = 255 * tent(center, radius, x, y);
        worst = std::max(worst, static_cast<double>(std::abs(picture.at(x, y) - expected)));
      });
      const double sum = static_cast<double>(picture.sum) / 255 / (4 * std::numbers::sqrt2 * radius);
      // floor(256 f), or its inverse, against 255 f.
      const bool is_right = worst <= 1 + 1e-9 && picture.again == 0 && picture.outside == 0;
      if (!is_right) FAIL_CHECK(kernel.name << ", radius " << radius << ": " << worst << ", " << picture.again);
      // Of r = 5 it is 1.005 % less, of all others nearer.
      if (std::abs(sum - 1) > 0.0101) FAIL_CHECK(kernel.name << ", radius " << radius << ": " << sum);
    }
  }
}

TEST_CASE("circles of real centre and radius are as defined, each pixel once") {
  Numbers numbers(1);
  for (int k = 0; k < (sanitized ? 60 : 600); ++k) {
    const Point center{numbers.real(-5, 5), k % 4 == 0 ? 0 : numbers.real(-5, 5)};
    const double radius = k % 3 == 0 ? numbers.real(3, 6) : numbers.real(3, 90);
    const PixelArea area = around(center, radius);
    Picture picture(area);
    two_point_circle(center, radius, 8, area, picture);
    double worst = 0;
    picture.for_each_pixel([&](int x, int y) {
      worst = std::max(worst, static_cast<double>(std::abs(picture.at(x, y) - 255 * tent(center, radius, x, y))));
    });
    CAPTURE(center.x, center.y, radius);
    CHECK(worst <= 1 + 1e-9);
    CHECK(picture.again == 0);
    CHECK(picture.outside == 0);
  }
}

TEST_CASE("a real circle about a pixel's middle is the one of roots") {
  for (int radius = 3; radius <= 120; ++radius) {
    const PixelArea area = around({0.5, 0.5}, radius);
    Picture rounded(area), real(area);
    two_point_circle(PixelCircle{{0, 0}, radius}, RootBand(radius, 8), 255, area, rounded);
    two_point_circle(Point{0.5, 0.5}, radius, 8, area, real);
    CHECK(rounded.differences(real) == 0);
  }
}

TEST_CASE("small circles are the areas of their pixels") {
  Numbers numbers(2);
  for (int k = 0; k < 60; ++k) {
    const double radius = k < 3 ? k : numbers.real(0, 3);
    const Point center = k < 3 ? Point{0.5, 0.5} : Point{numbers.real(-1, 1), numbers.real(-1, 1)};
    double total = 0, worst = 0;
    for (int y = -6; y < 6; ++y) {
      for (int x = -6; x < 6; ++x) {
        const double area = annulus_in_pixel(x - center.x, y - center.y, radius);
        total += area;
        // Chords of the two disks, line by line; of n lines the roots at a disk's ends cost n^-3/2.
        constexpr int lines = sanitized ? 2000 : 20000;
        double sum = 0;
        const auto chord = [&](double r, double v) {
          if (r <= 0 || std::abs(v) >= r) return 0.0;
          const double h = std::sqrt((r - v) * (r + v));
          return std::max(0.0, std::min(center.x + h, x + 1.0) - std::max(center.x - h, double(x)));
        };
        for (int line = 0; line < lines; ++line) {
          const double v = y + (line + 0.5) / lines - center.y;
          sum += chord(radius + 0.5, v) - chord(radius - 0.5, v);
        }
        worst = std::max(worst, std::abs(sum / lines - area));
      }
    }
    CAPTURE(radius, center.x, center.y);
    CHECK(worst <= 4 * std::pow(sanitized ? 2000 : 20000, -1.5));
    const double inner = std::max(radius - 0.5, 0.0);
    CHECK(std::abs(total - std::numbers::pi * ((radius + 0.5) * (radius + 0.5) - inner * inner)) <= 1e-13);
  }
}

TEST_CASE("midpoint circles have one pixel a row of each octant, without a gap") {
  for (int radius = 0; radius <= 200; ++radius) {
    const PixelArea area = around({0.5, 0.5}, radius);
    Picture picture(area);
    midpoint_circle({{0, 0}, radius}, area, picture);
    CAPTURE(radius);
    CHECK(picture.again == 0);
    int wrong = 0;
    std::uint64_t count = 0;
    picture.for_each_pixel([&](int x, int y) {
      const std::int64_t i = std::max(std::abs(x), std::abs(y)), j = std::min(std::abs(x), std::abs(y));
      const std::int64_t square = std::int64_t{radius} * radius - j * j;
      // |i - h| < 1 / 2.
      const bool nearest = radius == 0 ? i == 0 : square > i * i - i && square <= i * i + i;
      wrong += (picture.at(x, y) == 1) != nearest ? 1 : 0;
      count += nearest ? 1 : 0;
    });
    CHECK(wrong == 0);
    CHECK(picture.sum == count);
  }
}

TEST_CASE("Gupta-Sproull circles have each pixel once, by its distance from the circle") {
  const Cone& cone = Cone::tables();
  for (int radius = 0; radius <= 200; radius += radius < 20 ? 1 : 7) {
    const PixelArea area = around({0.5, 0.5}, radius);
    Picture picture(area);
    gupta_sproull_circle({{0, 0}, radius}, area, picture);
    CAPTURE(radius);
    CHECK(picture.again == 0);
    if (radius == 0) CHECK(picture.at(0, 0) == 255);
    if (radius == 0) continue;
    int wrong = 0, left_out = 0;
    picture.for_each_pixel([&](int x, int y) {
      const double distance = std::abs(std::hypot(x, y) - radius);
      const std::uint32_t expected = cone.endless(distance);
      // Three pixels a row leave out some of the cone's rim.
      if (picture.at(x, y) == 0) left_out = std::max(left_out, static_cast<int>(expected));
      // One entry beside, where two ways to the distance differ in the last place.
      const bool is_near = picture.at(x, y) >= cone.endless(distance + 1e-9) &&
                           picture.at(x, y) <= cone.endless(std::max(distance - 1e-9, 0.0));
      wrong += picture.at(x, y) > 0 && !is_near ? 1 : 0;
    });
    CHECK(wrong == 0);
    // At 45 degrees the fourth pixel lies at least 1.5 rows off, 1.06 across.
    CHECK(left_out <= 255 * cone_share(1, 1.06) + 2);
    if (radius > 10) {
      CHECK(std::abs(static_cast<double>(picture.sum) / 255 / (2 * std::numbers::pi * radius) - 1) <= 0.03);
    }
  }
}

}  // namespace moire::test
