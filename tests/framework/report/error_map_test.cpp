#include "report/error_map.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>

namespace moire::report {
namespace {

// What the eye takes for brightness: the Y of CIE XYZ for sRGB's primaries (Rec. 709).
double luminance(Color c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; }

}  // namespace

TEST_CASE("the absolute map is black at zero and brighter with every step") {
  CHECK(luminance(absolute_error_color(0, 8)) == 0);
  for (int i = 1; i <= 64; ++i) {
    CHECK(luminance(absolute_error_color(i / 8.0, 8)) > luminance(absolute_error_color((i - 1) / 8.0, 8)));
  }
}

TEST_CASE("the signed map is white at zero and darker with every step, bluer below and redder above") {
  const Color zero = signed_error_color(0, 8);
  CHECK((zero.r > 0.999F && zero.g > 0.999F && zero.b > 0.999F));
  for (int i = 1; i <= 64; ++i) {
    const Color below = signed_error_color(-i / 8.0, 8), above = signed_error_color(i / 8.0, 8);
    CHECK(luminance(below) < luminance(signed_error_color(-(i - 1) / 8.0, 8)));
    CHECK(luminance(above) < luminance(signed_error_color((i - 1) / 8.0, 8)));
    CHECK(below.b > below.r);
    CHECK(above.r > above.b);
  }
}

TEST_CASE("values beyond the scale have the colour of its end") {
  CHECK(absolute_error_color(9, 8) == absolute_error_color(8, 8));
  CHECK(signed_error_color(-HUGE_VAL, 8) == signed_error_color(-8, 8));
  CHECK(signed_error_color(HUGE_VAL, 8) == signed_error_color(8, 8));
}

TEST_CASE("what is not a number is green in both maps") {
  CHECK(absolute_error_color(std::nan(""), 8) == Color{0, 1, 0});
  CHECK(signed_error_color(std::nan(""), 8) == Color{0, 1, 0});
}

}  // namespace moire::report
