// Bresenham's lines against the definition: the pixel nearest to the line in its column.
#include "lines/bresenham.h"

#include <catch2/catch_test_macros.hpp>

#include "picture.h"

namespace moire::test {

using namespace scan_conversion;

TEST_CASE("Bresenham lines are the nearest pixels, of two as near the one farther from the line's start") {
  const PixelArea area{0, 0, 130, 130};
  for (std::int64_t dx = 1; dx <= 128; ++dx) {
    for (std::int64_t dy = 0; dy <= dx; ++dy) {
      int wrong = 0;
      std::int64_t columns = 0;
      bresenham_line({0, 0}, {dx, dy}, area, [&](int x, int y, std::uint32_t intensity) {
        // |y - x dy / dx| <= 1/2, below it strictly.
        const std::int64_t twice = 2 * (y * dx - x * dy);
        wrong += intensity != 1 || twice > dx || twice <= -dx || x != columns ? 1 : 0;
        ++columns;
      });
      if (wrong > 0 || columns != dx + 1) FAIL_CHECK("dx " << dx << ", dy " << dy);
    }
  }
}

}  // namespace moire::test
