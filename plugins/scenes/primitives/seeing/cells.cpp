#include "cells.h"

#include <numeric>

namespace primitives {

namespace {

// How far rounding may move the outline of a shape; generous, since all it costs is a few entries more.
double slack_of(const Shape& shape) {
  const moire::Rectangle box = box_of(shape);
  return 0.01 + 1e-14 * std::max({std::abs(box.x0), std::abs(box.y0), std::abs(box.x1), std::abs(box.y1)});
}

}  // namespace

Cells::Cells(std::span<const Shape> shapes, moire::ImageSize size)
    : columns_(static_cast<int>(std::ceil(size.width / side)) + 2 * margin),
      rows_(static_cast<int>(std::ceil(size.height / side)) + 2 * margin),
      first_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1),
      all_(shapes.size()) {
  std::iota(all_.rbegin(), all_.rend(), 0U);
  for (const std::uint32_t k : all_) {
    spread(shapes[k], [&](std::size_t cell) { ++first_[cell + 1]; });
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  entries_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (const std::uint32_t k : all_) {
    spread(shapes[k], [&](std::size_t cell) { entries_[next[cell]++] = k; });
  }
}

template <class Put>
void Cells::put_columns(int row, double x0, double x1, Put put) const {
  if (!(x1 >= left(0) && x0 <= left(columns_))) return;
  const std::size_t cell = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_);
  for (int column = column_of(x0); column <= column_of(x1); ++column) put(cell + static_cast<std::size_t>(column));
}

template <class Put>
void Cells::spread(const Shape& shape, Put put) const {
  const moire::Rectangle box = box_of(shape);
  const double slack = slack_of(shape);
  if (!(box.y1 + slack >= left(0) && box.y0 - slack <= left(rows_))) return;
  for (int row = row_of(box.y0 - slack); row <= row_of(box.y1 + slack); ++row) {
    const double y0 = left(row), y1 = left(row + 1);
    if (const Bar* const bar = std::get_if<Bar>(&shape)) {
      // The axis, as far as points within its reach may lie in this row.
      const double reach = bar->half_width() + slack;
      const moire::Point p = bar->from(), q = bar->to();
      double x0 = p.x, x1 = q.x;
      if (p.y != q.y) {
        const auto x_at = [&](double y) { return p.x + (q.x - p.x) * std::clamp((y - p.y) / (q.y - p.y), 0.0, 1.0); };
        x0 = x_at(y0 - reach);
        x1 = x_at(y1 + reach);
      }
      put_columns(row, std::min(x0, x1) - reach, std::max(x0, x1) + reach, put);
      continue;
    }
    const Ring& ring = *std::get_if<Ring>(&shape);
    const double outer = ring.outer + slack, inner = ring.inner - slack;
    const double from_top = std::abs(y0 - ring.center.y), from_bottom = std::abs(y1 - ring.center.y);
    const bool is_level = y0 <= ring.center.y && ring.center.y <= y1;
    const double nearest = is_level ? 0 : std::min(from_top, from_bottom), farthest = std::max(from_top, from_bottom);
    if (nearest > outer) continue;
    const auto half_chord = [](double radius, double distance) {
      return std::sqrt((radius - distance) * (radius + distance));
    };
    const double half = half_chord(outer, nearest);
    const double hole = inner > farthest ? half_chord(inner, farthest) : 0;
    // Whole cells within the hole are left out.
    if (hole > side) {
      put_columns(row, ring.center.x - half, ring.center.x - hole, put);
      put_columns(row, std::max(ring.center.x + hole, left(column_of(ring.center.x - hole) + 1)), ring.center.x + half,
                  put);
    } else {
      put_columns(row, ring.center.x - half, ring.center.x + half, put);
    }
  }
}

}  // namespace primitives
