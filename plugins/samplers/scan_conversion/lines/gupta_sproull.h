// Gupta-Sproull lines: the pixel nearest to the line in every column and the two around it, each by its distance.
#pragma once

#include "bresenham.h"
#include "cone.h"

namespace scan_conversion {

namespace gupta_sproull {

inline double length_of(const Octant& octant) {
  const double width = static_cast<double>(octant.columns), height = static_cast<double>(octant.rise);
  return std::sqrt(width * width + height * height);
}

// Columns within two of an end see it: each of their pixels by how far before and behind it the line ends.
template <class Put>
void draw_ends(const Octant& octant, Range columns, const moire::PixelArea& area, Put& put) {
  const NearestRows rows(octant);
  const double width = static_cast<double>(octant.columns), height = static_cast<double>(octant.rise);
  const double length = length_of(octant);
  const Cone& cone = Cone::tables();
  for (std::int64_t i = columns.first; i < columns.end; ++i) {
    const std::int64_t row = rows.row_at(i);
    for (std::int64_t j = row - 1; j <= row + 1; ++j) {
      if (!holds(area, octant.x(i, j), octant.y(i, j))) continue;
      const double u = static_cast<double>(i), v = static_cast<double>(j);
      const double along = (u * width + v * height) / length, across = (v * width - u * height) / length;
      const std::uint32_t intensity = cone.between(along, length - along, std::abs(across));
      put(static_cast<int>(octant.x(i, j)), static_cast<int>(octant.y(i, j)), intensity);
    }
  }
}

template <class Put>
void draw(const Octant& octant, Range columns, Put&& put) {
  if (columns.empty()) return;
  const Cone& cone = Cone::tables();
  NearestRows rows(octant);
  rows.go_to(columns.first);
  Pen pen(put, octant, columns.first, rows.row_at(columns.first));
  const double width = static_cast<double>(octant.columns), length = length_of(octant);
  const double apart = width / length, scale = 1 / (2 * length);
  for (std::int64_t i = columns.first; i < columns.end; ++i) {
    // From the middle pixel up to the line, square to it: at most 1 / 2, and apart at most 1.
    const double t = static_cast<double>(rows.residue() - octant.columns) * scale;
    pen.put_below(cone.within_reach(apart + t));
    pen.put(cone.within_reach(std::abs(t)));
    pen.put_above(cone.within_reach(apart - t));
    pen.move(rows.next());
  }
}

}  // namespace gupta_sproull

template <class Put>
void gupta_sproull_line(PixelIndex from, PixelIndex to, const moire::PixelArea& area, Put&& put) {
  if (from == to) {
    if (holds(area, from.x, from.y)) put(static_cast<int>(from.x), static_cast<int>(from.y), Cone::full);
    return;
  }
  const Octant octant = octant_of(from, to);
  // From the third column on no pixel's cone reaches the end, whatever the slope; nor one before the first.
  const std::int64_t first = std::min<std::int64_t>(2, octant.columns + 2);
  const std::int64_t end = std::max(first, octant.columns - 1);
  gupta_sproull::draw_ends(octant, {-1, first}, area, put);
  const NearestRows rows(octant);
  Visible part{{first, end}, true};
  if (!is_inside(from, to, area)) {
    part = visible(octant, {first, end}, area, -1, 1, [&](std::int64_t i) { return rows.row_at(i); });
  }
  if (part.all) {
    gupta_sproull::draw(octant, part.columns, put);
  } else {
    gupta_sproull::draw(octant, part.columns, Clipped{area, put});
  }
  gupta_sproull::draw_ends(octant, {end, octant.columns + 2}, area, put);
}

}  // namespace scan_conversion
