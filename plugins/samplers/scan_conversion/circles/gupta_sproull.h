// Gupta-Sproull circles: along the midpoint circle three pixels a row, each by its distance from the circle, as if the
// line were straight.
#pragma once

#include "../lines/cone.h"
#include "bands.h"
#include "small.h"

namespace scan_conversion {

template <class Put>
void gupta_sproull_circle(const PixelCircle& circle, const moire::PixelArea& area, Put&& put) {
  const Cone& cone = Cone::tables();
  const std::int64_t radius = circle.radius;
  const auto put_at = [&](auto x, auto y, std::int64_t i, std::int64_t j, auto& put_pixel) {
    using Number = decltype(x);
    const double u = static_cast<double>(i), v = static_cast<double>(j), r = static_cast<double>(radius);
    // sqrt(u^2 + v^2) - r without loss.
    const double distance = std::abs((u - r) * (u + r) + v * v) / (std::sqrt(u * u + v * v) + r);
    const std::uint32_t intensity = radius == 0 ? cone.full : cone.endless(distance);
    put_images(x, y, static_cast<Number>(i), static_cast<Number>(j), intensity, put_pixel);
  };
  // Where rows are few, three pixels of each are not all that the circle comes near.
  if (radius < smallest_octants) {
    const Clipped clipped{area, put};
    const std::int64_t reach = radius == 0 ? 0 : radius + 1;
    for (std::int64_t j = 0; j <= reach; ++j) {
      for (std::int64_t i = j; i <= reach; ++i) put_at(circle.center.x, circle.center.y, i, j, clipped);
    }
    return;
  }
  // Two rows more than half the diagonal has have pixels this side of it.
  for_visible_rows(circle, circle.last_row() + 2, 1, area, put, [&](Rows rows, auto x, auto y, auto& put_pixel) {
    MidpointBand band(radius);
    band.go_to(rows.first);
    for (std::int64_t j = rows.first; j < rows.end; ++j, band.next()) {
      for (std::int64_t i = std::max(band.i() - 1, j); i <= band.i() + 1; ++i) put_at(x, y, i, j, put_pixel);
    }
  });
}

}  // namespace scan_conversion
