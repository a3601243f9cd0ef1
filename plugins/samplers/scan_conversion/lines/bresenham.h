// Bresenham lines: in every column the pixel nearest to the line. After Bresenham 1965, doi:10.1147/sj.41.0025.
#pragma once

#include "octant.h"
#include "pen.h"

namespace scan_conversion {

// The row nearest to f(i) = rise i / columns; of two as near, the upper one. `residue` is what the rounding left:
// f - row = (residue - columns) / (2 columns), residue in 0 .. 2 columns - 1.
class NearestRows {
 public:
  explicit NearestRows(const Octant& octant) : rise_(octant.rise), columns_(std::max<std::int64_t>(octant.columns, 1)) {
    go_to(0);
  }

  std::int64_t row_at(std::int64_t i) const {
    const SignedWide numerator = twice_f(i), width = 2 * columns_;
    return static_cast<std::int64_t>(numerator >= 0 ? numerator / width : -((width - 1 - numerator) / width));
  }
  void go_to(std::int64_t i) {
    residue_ = static_cast<std::int64_t>(twice_f(i) - SignedWide{row_at(i)} * 2 * columns_);
  }
  std::int64_t residue() const { return residue_; }
  // To the next column; how many rows it lies higher.
  int next() {
    residue_ += 2 * rise_;
    const bool steps = residue_ >= 2 * columns_;
    residue_ -= steps ? 2 * columns_ : 0;
    return steps ? 1 : 0;
  }

 private:
  // 2 columns (f + 1 / 2).
  SignedWide twice_f(std::int64_t i) const { return SignedWide{2} * i * rise_ + columns_; }

  std::int64_t rise_, columns_, residue_ = 0;
};

template <class Put>
void bresenham_line(PixelIndex from, PixelIndex to, const moire::PixelArea& area, Put&& put) {
  const Octant octant = octant_of(from, to);
  NearestRows rows(octant);
  Range columns{0, octant.columns + 1};
  if (!is_inside(from, to, area)) {
    columns = visible(octant, columns, area, 0, 0, [&](std::int64_t i) { return rows.row_at(i); }).columns;
    if (columns.empty()) return;
  }
  Pen pen(put, octant, columns.first, rows.row_at(columns.first));
  rows.go_to(columns.first);
  for (std::int64_t i = columns.first; i < columns.end; ++i) {
    pen.put(1);
    pen.move(rows.next());
  }
}

}  // namespace scan_conversion
