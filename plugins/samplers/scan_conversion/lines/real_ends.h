// Two-point lines between real end points: D starts at the fraction in the middle of the first column, and the columns
// at the ends get as much of their weight as the line covers of them. Rounded end points make moving lines flicker.
#pragma once

#include "two_point.h"

namespace scan_conversion {

// A line from its lower to its upper column, seen in the first octant.
struct RealOctant {
  Octant octant;         // column 0 holds the line's begin, row 0 is floor(f) there; its rise is left to f
  Slope slope;           // f
  double first_covered;  // of column 0
  double last_covered;   // of column octant.columns
};

// Requires: from != to, both within reach.
inline RealOctant real_octant(moire::Point from, moire::Point to) {
  // Coordinates that are whole in the middles of pixels can be mirrored.
  const double x0 = from.x - 0.5, y0 = from.y - 0.5, dx = to.x - from.x, dy = to.y - from.y;
  const bool steep = std::abs(dy) > std::abs(dx);
  const Step x{dx < 0 ? -1 : 1, 0}, y{0, dy < 0 ? -1 : 1};
  const Step column = steep ? y : x, row = steep ? x : y;
  const double u = (steep ? y0 : x0) * (column.x + column.y), v = (steep ? x0 : y0) * (row.x + row.y);
  const double length = std::abs(steep ? dy : dx), rise = std::abs(steep ? dx : dy);
  const double first = std::floor(u + 0.5), last = std::max(first, std::ceil(u + length - 0.5));
  Slope slope{length, rise, first - u, v};
  const double row0 = std::floor(slope.at(0));
  slope.start -= row0;
  const auto index = [](double part, int step) { return static_cast<std::int64_t>(part * step); };
  const PixelIndex origin{steep ? index(row0, row.x) : index(first, column.x),
                          steep ? index(first, column.y) : index(row0, row.y)};
  const double end = u + length;
  return {{origin, static_cast<std::int64_t>(last - first), 0, column, row},
          slope,
          std::min(first + 0.5, end) - u,
          last > first ? end - (last - 0.5) : 0};
}

namespace two_point {

template <class Walk, class Put>
void draw_faded(const Octant& octant, Walk walk, std::int64_t i, double covered, std::uint32_t full,
                const moire::PixelArea& area, Put& put) {
  const std::int64_t row = walk.row_at(i);
  // Column and row may be anywhere, and numbers of pixels that `put` takes are of pixels.
  if (!holds(area, octant.x(i, row), octant.y(i, row)) && !holds(area, octant.x(i, row + 1), octant.y(i, row + 1))) {
    return;
  }
  walk.go_to(i);
  // The sum is rounded first: it is what stands still while a line moves.
  const auto sum = static_cast<std::uint64_t>(std::floor(covered * full + 0.5));
  const auto upper = static_cast<std::uint32_t>((2 * sum * walk.upper() + full) / (2 * std::uint64_t{full}));
  const auto put_inside = Clipped{area, put};
  const int x = static_cast<int>(octant.x(i, row)), y = static_cast<int>(octant.y(i, row));
  put_inside(x, y, static_cast<std::uint32_t>(sum) - upper);
  put_inside(x + octant.row.x, y + octant.row.y, upper);
}

}  // namespace two_point

// A line without length is its pixel, as with rounded end points.
template <class Put>
void two_point_line(const TwoPointLines& how, moire::Point from, moire::Point to, const moire::PixelArea& area,
                    Put&& put) {
  const std::uint32_t full = how.full();
  if (from == to) return two_point::draw_single(pixel_of(from), pixel_of(from), full, area, put);
  const RealOctant line = real_octant(from, to);
  const auto draw = [&](const auto& walk) {
    const std::int64_t last = line.octant.columns;
    two_point::draw_faded(line.octant, walk, 0, line.first_covered, full, area, put);
    two_point::draw_visible(line.octant, walk, {1, last}, area, put);
    if (last > 0) two_point::draw_faded(line.octant, walk, last, line.last_covered, full, area, put);
  };
  if (how.method == LineMethod::direct) return draw(Direct<true>(line.slope, how.grey_bits));
  if (how.method == LineMethod::fujimoto_iwata) return draw(PerPixel<true>(line.slope, how.grey_bits));
  const bool wide = how.is_wide(line.slope.columns, line.slope.columns);
  const int n = how.word_bits(wide);
  const Wide d = how.increment(line.slope.rise / line.slope.columns, n);
  // Rounding may have led out of the first row.
  const double fraction = std::clamp(line.slope.at(0), 0.0, 1 - 0x1p-53);
  const auto first = static_cast<std::uint64_t>(std::ldexp(fraction, n));
  if (d >> n != 0) {
    const int shift = n - how.grey_bits;
    const std::uint64_t upper = shift < 0 ? first << -shift : first >> shift;
    return draw(Straight(1, static_cast<std::uint32_t>(upper), how.grey_bits));
  }
  if (wide) {
    return draw(
        Accumulator<std::uint64_t>(static_cast<std::uint64_t>(d << (64 - n)), first << (64 - n), how.grey_bits));
  }
  draw(Accumulator<std::uint32_t>(static_cast<std::uint32_t>(d << (32 - n)),
                                  static_cast<std::uint32_t>(first << (32 - n)), how.grey_bits));
}

}  // namespace scan_conversion
