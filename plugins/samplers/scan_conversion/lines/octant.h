// The eight octants made one: columns along the line, rows across it.
#pragma once

#include <algorithm>

#include "../pixels.h"

namespace scan_conversion {

struct Step {
  int x = 0, y = 0;
};

// A line seen from one of its ends: column 0, row 0 is `origin`. In the octant itself rise / columns is its slope,
// 0 <= rise <= columns.
struct Octant {
  PixelIndex origin;
  std::int64_t columns = 0, rise = 0;  // from the first pixel to the last
  Step column, row;                    // to the next column, to the next row

  std::int64_t x(std::int64_t i, std::int64_t j) const { return origin.x + i * column.x + j * row.x; }
  std::int64_t y(std::int64_t i, std::int64_t j) const { return origin.y + i * column.y + j * row.y; }
};

inline Octant octant_of(PixelIndex from, PixelIndex to) {
  const std::int64_t dx = to.x - from.x, dy = to.y - from.y;
  const std::int64_t width = dx < 0 ? -dx : dx, height = dy < 0 ? -dy : dy;
  const Step x{dx < 0 ? -1 : 1, 0}, y{0, dy < 0 ? -1 : 1};
  return height > width ? Octant{from, height, width, y, x} : Octant{from, width, height, x, y};
}

// The same line seen from its other end. Requires: it rises.
inline Octant reversed(const Octant& octant) {
  const std::int64_t i = octant.columns, j = octant.rise;
  return {{octant.x(i, j), octant.y(i, j)}, i, j, {-octant.column.x, -octant.column.y}, {-octant.row.x, -octant.row.y}};
}

// Whether all pixels of a line, and those beside them, lie in the area.
inline bool is_inside(PixelIndex from, PixelIndex to, const moire::PixelArea& area) {
  const moire::PixelArea inner{area.x0 + 1, area.y0 + 1, area.width - 2, area.height - 2};
  return holds(inner, from.x, from.y) && holds(inner, to.x, to.y);
}

struct Range {
  std::int64_t first = 0, end = 0;

  bool empty() const { return first >= end; }
};
inline Range common(Range a, Range b) { return {std::max(a.first, b.first), std::min(a.end, b.end)}; }

// Which of `columns` have a pixel in the area, and whether all their pixels are. Pixels lie in rows row_at(i) + lowest
// .. row_at(i) + highest; row_at does not fall. Where a line starts to be visible is found by halving, so that what is
// drawn there comes of the same arithmetic as without an area.
struct Visible {
  Range columns;
  bool all = true;
};
template <class RowAt>
Visible visible(const Octant& octant, Range columns, const moire::PixelArea& area, int lowest, int highest,
                RowAt row_at) {
  const auto numbers = [](std::int64_t first, std::int64_t count, std::int64_t origin, int step) {
    return step > 0 ? Range{first - origin, first + count - origin}
                    : Range{origin - first - count + 1, origin - first + 1};
  };
  const bool steep = octant.column.x == 0;
  const Range x = numbers(area.x0, area.width, octant.origin.x, octant.column.x + octant.row.x);
  const Range y = numbers(area.y0, area.height, octant.origin.y, octant.column.y + octant.row.y);
  const Range rows = steep ? x : y;
  columns = common(columns, steep ? y : x);
  if (columns.empty() || rows.empty()) return {{}, true};
  if (row_at(columns.first) + lowest >= rows.first && row_at(columns.end - 1) + highest < rows.end) return {columns};
  const auto first_in_row = [&](std::int64_t row) {
    Range left = columns;
    while (!left.empty()) {
      const std::int64_t middle = left.first + (left.end - left.first) / 2;
      (row_at(middle) < row ? left.first : left.end) = middle + (row_at(middle) < row ? 1 : 0);
    }
    return left.first;
  };
  return {{first_in_row(rows.first - highest), first_in_row(rows.end - lowest)}, false};
}

}  // namespace scan_conversion
