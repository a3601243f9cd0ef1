// Which shapes may cover which part of the image: lists of shapes for square cells, made once for all questions.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "shapes.h"

namespace primitives {

class Cells {
 public:
  // Shapes back to front; the lists name them front to back, by their places.
  Cells(std::span<const Shape> shapes, moire::ImageSize size);

  // All shapes that may cover a point. Wherever it lies.
  std::span<const std::uint32_t> at(moire::Point p) const {
    const double x = std::floor(p.x * (1 / side)) + margin, y = std::floor(p.y * (1 / side)) + margin;
    if (!(x >= 0 && y >= 0 && x < columns_ && y < rows_)) return all_;
    return list(static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x));
  }

  // Calls see(shape) for all shapes that may cover points of the stretch from p to q, some of them more than once.
  template <class See>
  void along(moire::Point p, moire::Point q, See see) const;

 private:
  static constexpr double side = 8;  // pixels
  static constexpr int margin = 4;   // cells around the image: filters ask beyond it

  std::span<const std::uint32_t> list(std::size_t cell) const {
    return std::span(entries_).subspan(first_[cell], first_[cell + 1] - first_[cell]);
  }
  double left(int column) const { return side * (column - margin); }
  int column_of(double x) const {
    return static_cast<int>(std::clamp(std::floor(x * (1 / side)) + margin, 0.0, columns_ - 1.0));
  }
  int row_of(double y) const {
    return static_cast<int>(std::clamp(std::floor(y * (1 / side)) + margin, 0.0, rows_ - 1.0));
  }
  bool holds(moire::Point p) const {
    return p.x >= left(0) && p.y >= left(0) && p.x <= left(columns_) && p.y <= left(rows_);
  }

  // Calls put(cell) for the cells that a shape may touch.
  template <class Put>
  void spread(const Shape& shape, Put put) const;
  template <class Put>
  void put_columns(int row, double x0, double x1, Put put) const;

  int columns_, rows_;
  std::vector<std::size_t> first_;  // entry of each cell
  std::vector<std::uint32_t> entries_, all_;
};

template <class See>
void Cells::along(moire::Point p, moire::Point q, See see) const {
  if (!holds(p) || !holds(q)) {
    for (const std::uint32_t shape : all_) see(shape);
    return;
  }
  if (q.x < p.x) std::swap(p, q);
  constexpr double slack = 1e-6;  // more than rounding moves a place within the cells
  const double slope = q.x > p.x ? (q.y - p.y) / (q.x - p.x) : 0;
  for (int column = column_of(p.x - slack); column <= column_of(q.x + slack); ++column) {
    const double x0 = std::clamp(left(column) - slack, p.x, q.x), x1 = std::clamp(left(column + 1) + slack, p.x, q.x);
    const bool is_upright = !(q.x - p.x > slack);
    const double y0 = is_upright ? p.y : p.y + slope * (x0 - p.x), y1 = is_upright ? q.y : p.y + slope * (x1 - p.x);
    for (int row = row_of(std::min(y0, y1) - slack); row <= row_of(std::max(y0, y1) + slack); ++row) {
      const std::size_t cell = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_);
      for (const std::uint32_t shape : list(cell + static_cast<std::size_t>(column))) see(shape);
    }
  }
}

}  // namespace primitives
