// Gupta and Sproull's cone, its tables and the lines drawn by them, against the integral itself.
#include "lines/cone.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>

#include "lines/gupta_sproull.h"
#include "picture.h"
#include "sanitized.h"

namespace moire::test {
namespace {

using namespace scan_conversion;

// The cone over a half-strip, on a grid of points.
double summed(double along, double across) {
  constexpr int n = 800;
  double sum = 0;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const double x = 2 * (i + 0.5) / n - 1, y = 2 * (j + 0.5) / n - 1;
      if (x >= -along && std::abs(y - across) <= 0.5) sum += std::max(0.0, 1 - std::hypot(x, y));
    }
  }
  return sum * (4.0 / n / n) * (3 / std::numbers::pi);
}

}  // namespace

TEST_CASE("the cone's share of a line is its integral") {
  CHECK(std::abs(cone_share(1, 0) + 2 * cone_share(1, 1) - 1) <= 3e-5);
  for (const double across : {0.0, 0.2, 0.5, 0.9, 1.3, 1.6}) {
    for (const double along : {-1.2, -0.7, -0.1, 0.0, 0.4, 0.95, 1.0, 3.0}) {
      CAPTURE(across, along);
      // Rows and columns of points at the strip's edges count whole or not: half of 2 / n of the densest of them, 0.96
      // high, at each of three edges.
      CHECK(std::abs(cone_share(along, across) - summed(along, across)) <= 3 * 0.5 * (2.0 / 800) * 0.96);
      // Two halves are a whole.
      CHECK(std::abs(cone_share(along, across) + cone_share(-along, across) - cone_share(1, across)) <= 3e-5);
    }
  }
}

TEST_CASE("a table's entry is within half a step of the cone's share") {
  const Cone& cone = Cone::tables();
  // The share falls by no more than the cone's densest cross section, 3 / pi, a pixel.
  const double tolerance = 0.5 + 255 * (3 / std::numbers::pi) * (Cone::reach / Cone::entries / 2);
  for (int k = 0; k <= 1500; ++k) {
    const double across = k / 1000.0;
    CHECK(std::abs(cone.endless(across) - 255 * cone_share(1, across)) <= tolerance + 1e-9);
  }
  CHECK(cone.endless(1.5) == 0);
  CHECK(cone.endless(100) == 0);
}

TEST_CASE("pixels of a Gupta-Sproull line are the cone's share of it, its ends included") {
  const PixelArea area{-60, -60, 120, 120};
  Numbers numbers(1);
  // Steps of 1.5 / 64 across and of 2 / 64 along at both ends, each rounded to its middle.
  const double strip = 255 * (3 / std::numbers::pi) * (Cone::reach / Cone::entries / 2) + 0.5;
  const double end = 255 * (3 / std::numbers::pi) * (Cone::reach / Cone::entries / 2 + 1.0 / Cone::entries);
  for (int k = 0; k < (sanitized ? 20 : 60); ++k) {
    const std::int64_t width = k < 20 ? k / 4 + 1 : numbers.integer(1, 50), height = numbers.integer(0, width);
    const double length = std::hypot(static_cast<double>(width), static_cast<double>(height));
    Picture picture(area);
    gupta_sproull_line({0, 0}, {width, height}, area, picture);
    CHECK(picture.again == 0);
    picture.for_each_pixel([&](int x, int y) {
      if (std::abs(y * width - x * height) > 4 * width) return;
      const double along = (x * static_cast<double>(width) + y * static_cast<double>(height)) / length;
      const double across = (y * static_cast<double>(width) - x * static_cast<double>(height)) / length;
      const double share = cone_share(along, std::abs(across)) + cone_share(length - along, std::abs(across)) -
                           cone_share(1, std::abs(across));
      const bool three = 2 * std::abs(y * width - x * height) < 3 * width;  // of each column
      const bool at_ends = along < 1 || length - along < 1;
      const double tolerance =
          three ? strip + (at_ends ? 2 * end + 1 : 0) : 255 * cone_share(1, 1.5 * static_cast<double>(width) / length);
      if (std::abs(picture.at(x, y) - 255 * share) > tolerance + 1e-9) {
        FAIL_CHECK("(" << width << ", " << height << ") at " << x << ", " << y << ": " << picture.at(x, y) << " for "
                       << 255 * share);
      }
    });
    if (length > 20) CHECK(std::abs(static_cast<double>(picture.sum) / 255 - length) <= 0.03 * length);
  }
}

}  // namespace moire::test
