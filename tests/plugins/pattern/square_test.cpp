// Areas in a pixel: closed forms held to clipping and to Archimedes' segments, with 64 bits of mantissa.
#include "weights/square.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>

#include "clipped_area.h"
#include "numbers.h"

namespace moire::test {

namespace {

using pattern::Square;

// Directions of all sorts, in radians: along the axes, nearly so, rational slopes, diagonal.
std::vector<double> angles() {
  std::vector<double> result{
      0, 1e-16, 1e-12, 1e-8, 1e-5, 1e-3, 0.02, std::atan(1.0 / 3), std::atan(0.5), 0.7, std::numbers::pi / 4};
  Numbers numbers;
  for (int k = 0; k < 20; ++k) result.push_back(numbers.between(0, std::numbers::pi / 2));
  return result;
}

long double clipped_half_plane(double a, double b, double s) {
  return area(clipped(pixel_square(-0.5L, -0.5L), [&](LongPoint p) { return a * p.x + b * p.y + s; }));
}

// By the antiderivative of the half chord, over the columns from x0 to x1 and below y.
long double disk_below(long double r, long double x0, long double x1, long double y) {
  // The angle by its tangent: the arc sine loses half of its digits near r.
  const auto antiderivative = [r](long double x) {
    const long double h = std::sqrt((r - x) * (r + x));
    return (x * h + r * r * std::atan2(x, h)) / 2;
  };
  const auto chord = [&](long double from, long double to) {
    from = std::clamp(from, -r, r), to = std::clamp(to, -r, r);
    return from < to ? antiderivative(to) - antiderivative(from) : 0.0L;
  };
  // Columns whose half chord h is above |y| are cut by the line: y + h of them, others are whole or none.
  const long double cut = std::abs(y) < r ? std::sqrt((r - y) * (r + y)) : 0;
  const long double from = std::max(x0, -cut), to = std::min(x1, cut);
  const long double inner = from < to ? chord(from, to) + y * (to - from) : 0;
  const long double outer = chord(x0, std::min(x1, -cut)) + chord(std::max(x0, cut), x1);
  return inner + (y > 0 ? 2 * outer : 0);
}

double long_disk(double x, double y, double r) {
  const long double x0 = -0.5L - x, y0 = -0.5L - y;
  return static_cast<double>(disk_below(r, x0, x0 + 1, y0 + 1) - disk_below(r, x0, x0 + 1, y0));
}

}  // namespace

TEST_CASE("the area of a half-plane in a pixel is that of the clipped square, to rounding, at every angle") {
  Numbers numbers(2);
  for (const double angle : angles()) {
    const double a = std::cos(angle), b = std::sin(angle);
    for (int k = -40; k <= 40; ++k) {
      const double s = k % 2 == 0 ? k / 50.0 : numbers.between(-0.8, 0.8);
      CAPTURE(angle, s);
      // Sums and quotients of numbers up to 1: some roundings of 1e-16.
      CHECK(std::abs(Square::half_plane(a, b, s) - static_cast<double>(clipped_half_plane(a, b, s))) < 1e-15);
      CHECK(Square::half_plane(a, b, s) == Square::half_plane(b, a, s));
    }
  }
}

TEST_CASE("a half-plane that ends on a pixel's border covers all of it or nothing") {
  CHECK(Square::half_plane(1, 0, 0.5) == 1);
  CHECK(Square::half_plane(1, 0, -0.5) == 0);
  CHECK(Square::half_plane(0, 1, 0.5) == 1);
  CHECK(Square::half_plane(0, 1, 0) == 0.5);
  CHECK(Square::half_plane(0.25, 0, 0.0625) == 0.75);
  // No gradient: all or nothing.
  CHECK(Square::half_plane(0, 0, 1e-9) == 1);
  CHECK(Square::half_plane(0, 0, -1e-9) == 0);
}

TEST_CASE("around a polygon, lines add up to its clipped area") {
  Numbers numbers(3);
  for (int k = 0; k < 2000; ++k) {
    // A triangle that turns from x to y; every third is very flat.
    LongPolygon polygon;
    std::vector<Point> points;
    const double flat = k % 3 == 0 ? 1e-9 : 1;
    for (int i = 0; i < 3; ++i) points.push_back({numbers.between(-1.5, 1.5), flat * numbers.between(-1.5, 1.5)});
    for (const Point& p : points) polygon.push_back({p.x, p.y});
    if (area(polygon) < 0) {
      std::swap(points[0], points[1]);
      std::swap(polygon[0], polygon[1]);
    }
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += Square::along(points[i], points[(i + 1) % 3]);
    CAPTURE(k);
    CHECK(std::abs(sum - static_cast<double>(common_area(pixel_square(-0.5L, -0.5L), polygon))) < 3e-15);
  }
}

TEST_CASE("the area of a disk in a pixel is that of the chords, for disks from a thousandth of a pixel to thousands") {
  Numbers numbers(4);
  for (const double r : {1e-3, 0.1, 0.3, 0.5, std::numbers::sqrt2 / 2, 0.9, 1.5, 20.3, 300.0, 5000.0}) {
    for (int k = 0; k < 500; ++k) {
      const double angle = numbers.between(-4, 4), distance = r + numbers.between(-1, 1);
      const double x = k < 9 ? (k % 3 - 1) * r : distance * std::cos(angle);
      const double y = k < 9 ? (k / 3 - 1) * r : distance * std::sin(angle);
      CAPTURE(r, x, y);
      // What is checked against subtracts areas of r^2, with 5e-20 of each; heights are rounded to 1e-16 r.
      CHECK(std::abs(Square::disk({x, y}, r) - long_disk(x, y, r)) < 1e-15 + 4e-16 * r + 2e-19 * r * r);
    }
  }
}

TEST_CASE("disks within a pixel, around it and touching it") {
  CHECK(std::abs(Square::disk({0.1, -0.1}, 0.25) - std::numbers::pi / 16) < 1e-16);
  CHECK(std::abs(Square::disk({0, 0}, 0.5) - std::numbers::pi / 4) < 2e-16);
  CHECK(Square::disk({0, 0}, 0.75) == 1);
  CHECK(Square::disk({1.5, 0}, 1) == 0);
  CHECK(std::abs(Square::disk({0.5, 0.5}, 0.5) - std::numbers::pi / 16) < 1e-16);
}

TEST_CASE("four quarters of a pixel hold what the pixel holds") {
  Numbers numbers(5);
  for (int k = 0; k < 1000; ++k) {
    const double r = std::exp(numbers.between(-5, 5));
    const Point middle{numbers.between(-1, 1) * (r + 0.5), numbers.between(-1, 1) * (r + 0.5)};
    double quarters = 0;
    for (const double x : {-0.25, 0.25}) {
      for (const double y : {-0.25, 0.25})
        quarters += Square::disk({2 * (middle.x - x), 2 * (middle.y - y)}, 2 * r) / 4;
    }
    CAPTURE(r, middle.x, middle.y);
    CHECK(std::abs(quarters - Square::disk(middle, r)) < 1e-15 + 4e-16 * r);
  }
}

}  // namespace moire::test
