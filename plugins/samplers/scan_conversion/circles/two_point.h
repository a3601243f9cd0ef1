// Two-point circles: in every row of an octant the two pixels around the circle, each by how near it is. After Wu 1991,
// doi:10.1145/122718.122734; a tail row closes the diagonal, and every pixel is put once.
#pragma once

#include "bands.h"
#include "small.h"

namespace scan_conversion {

// About a pixel's middle. `band` is one of bands.h of this circle's radius. Requires: radius >= smallest_octants.
template <class Band, class Put>
void two_point_circle(const PixelCircle& circle, Band band, std::uint32_t full, const moire::PixelArea& area,
                      Put&& put) {
  const std::int64_t last = circle.last_row();
  for_visible_rows(circle, last + 1, 0, area, put, [&](Rows rows, auto x, auto y, auto& put_pixel) {
    using Number = decltype(x);
    band.go_to(rows.first);
    for (std::int64_t j = rows.first; j < rows.end; ++j) {
      // The tail row has its pixels on the diagonal alone, if it comes near enough; there h may fall by more than 1,
      // which no comparison with the row before could tell.
      if (j > last) band.go_to(j);
      const std::int64_t i = band.i();
      const std::uint32_t inner = band.inner();
      // The next row's root takes as long as this row's pixels.
      if (j < last) band.next();
      if (i >= j) put_images(x, y, static_cast<Number>(i), static_cast<Number>(j), inner ^ full, put_pixel);
      if (i > j) put_images(x, y, static_cast<Number>(i - 1), static_cast<Number>(j), inner, put_pixel);
    }
  });
}

// Any centre and radius: a pixel (dx, dy) from the centre has its intensity from the circle's place in its row where
// |dx| >= |dy|, in its column elsewhere. Requires: radius >= smallest_octants.
template <class Put>
void two_point_circle(moire::Point center, double radius, int grey_bits, const moire::PixelArea& area, Put&& put) {
  const double scale = std::ldexp(1.0, grey_bits);
  const std::uint32_t full = static_cast<std::uint32_t>(scale) - 1;
  const Clipped put_inside{area, put};
  // One side of the circle: lines of pixels across it, numbered v, on each a pair of pixels numbered u.
  const auto draw_side = [&](bool upright, int sign) {
    const double u0 = upright ? center.y : center.x, v0 = upright ? center.x : center.y;
    const int first_u = upright ? area.y0 : area.x0, count_u = upright ? area.height : area.width;
    const int first_v = upright ? area.x0 : area.y0, count_v = upright ? area.width : area.height;
    const double near = sign > 0 ? first_u - u0 : u0 - first_u - count_u;
    const Rows reach = offsets_between(radius, near, near + count_u);
    if (reach.end == 0) return;
    const auto draw_line = [&](std::int64_t v) {
      const double across = std::abs((static_cast<double>(v) + 0.5) - v0);
      if (across >= radius) return;
      const double h = std::sqrt((radius - across) * (radius + across)), place = sign * (u0 - 0.5) + h;
      const double outside = std::ceil(place);
      const auto inner = static_cast<std::uint32_t>((outside - place) * scale);
      const auto put_pixel = [&](double number, std::uint32_t intensity) {
        const auto u = sign * static_cast<std::int64_t>(number);
        const double along = std::abs((static_cast<double>(u) + 0.5) - u0);
        if (along < across || (upright && along == across)) return;
        put_inside(upright ? v : u, upright ? u : v, intensity);
      };
      put_pixel(outside, inner ^ full);
      put_pixel(outside - 1, inner);
    };
    // Beyond the diagonal nothing is this side's, but for the width of what is drawn.
    const double last = std::min(static_cast<double>(reach.end), radius * 0x1.6a09e667f3bcdp-1 + 2);
    const std::int64_t end = std::min(whole(v0 + last) + 1, std::int64_t{first_v} + count_v);
    const std::int64_t gap_first = whole(v0 - static_cast<double>(reach.first)) + 1;
    const std::int64_t gap_end = std::max(gap_first, whole(v0 + static_cast<double>(reach.first)));
    const std::int64_t begin = std::max(whole(v0 - last), std::int64_t{first_v});
    for (std::int64_t v = begin; v < std::min(gap_first, end); ++v) draw_line(v);
    for (std::int64_t v = std::max(begin, reach.first > 0 ? gap_end : gap_first); v < end; ++v) draw_line(v);
  };
  for (const bool upright : {false, true}) {
    for (const int sign : {1, -1}) draw_side(upright, sign);
  }
}

}  // namespace scan_conversion
