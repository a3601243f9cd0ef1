// Midpoint circles: in every row of an octant the pixel nearest to the circle. After Bresenham 1977,
// doi:10.1145/359423.359432.
#pragma once

#include "bands.h"

namespace scan_conversion {

template <class Put>
void midpoint_circle(const PixelCircle& circle, const moire::PixelArea& area, Put&& put) {
  const std::int64_t last = circle.radius == 0 ? 0 : circle.last_row() + 1;
  for_visible_rows(circle, last, 0, area, put, [&](Rows rows, auto x, auto y, auto& put_pixel) {
    using Number = decltype(x);
    MidpointBand band(circle.radius);
    band.go_to(rows.first);
    for (std::int64_t j = rows.first; j < rows.end && band.i() >= j; ++j, band.next()) {
      put_images(x, y, static_cast<Number>(band.i()), static_cast<Number>(j), 1U, put_pixel);
    }
  });
}

}  // namespace scan_conversion
