// Circles too small for octants: radii below 3, by the area of each pixel within half a pixel of the circle.
#pragma once

#include "../pixels.h"

namespace scan_conversion {

inline constexpr int smallest_octants = 3;

// The area that the annulus radius - 1/2 .. radius + 1/2 about (0, 0) has within the unit square from (x, y) on; of
// radii below 1/2, the disk. Exact to 1e-15 at small radii; r^2 times the last place is lost at others.
double annulus_in_pixel(double x, double y, double radius);

template <class Put>
void small_circle(moire::Point center, double radius, std::uint32_t full, const moire::PixelArea& area, Put&& put) {
  const double reach = radius + 0.5;
  const std::int64_t right = whole(center.x + reach), lower = whole(center.y + reach);
  for (std::int64_t y = whole(center.y - reach); y <= lower; ++y) {
    for (std::int64_t x = whole(center.x - reach); x <= right; ++x) {
      if (!holds(area, x, y)) continue;
      const double share =
          annulus_in_pixel(static_cast<double>(x) - center.x, static_cast<double>(y) - center.y, radius);
      put(static_cast<int>(x), static_cast<int>(y), static_cast<std::uint32_t>(std::lround(share * full)));
    }
  }
}

}  // namespace scan_conversion
