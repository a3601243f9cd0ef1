#include "hard/shadow_raster.h"

#include <algorithm>
#include <cmath>

#include "seeing/difference.h"

namespace shadow_planes {

ShadowRaster::ShadowRaster(int columns, int rows, moire::ShadowEdges edges)
    : columns_(columns),
      rows_(rows),
      is_by_area_(edges == moire::ShadowEdges::by_area),
      change_(static_cast<std::size_t>(columns) + 2),
      touched_((static_cast<std::size_t>(columns) + 2 + 63) / 64) {}

void ShadowRaster::clear() {
  shadows_.clear();
  boxes_.clear();
  edges_.clear();
}

void ShadowRaster::add(const Outline& shadow) {
  if (!is_by_area_) {
    add_piece(shadow);
    return;
  }
  const moire::Rectangle box = box_of(shadow);
  pieces_.assign(1, shadow);
  for (std::size_t k = 0; k < shadows_.size(); ++k) {
    if (!touch(box, boxes_[k])) continue;
    next_.clear();
    for (Outline& piece : pieces_) {
      if (are_apart(shadows_[k], piece)) {
        next_.push_back(std::move(piece));
      } else {
        cut_out(piece, shadows_[k], 0, next_, inside_, outside_);
      }
    }
    std::swap(pieces_, next_);
  }
  for (const Outline& piece : pieces_) add_piece(piece);
  shadows_.push_back(shadow);
  boxes_.push_back(box);
}

void ShadowRaster::add_piece(const Outline& piece) {
  const moire::Point* from = &piece.back();
  for (const moire::Point& to : piece) {
    const bool is_down = to.y > from->y;
    const moire::Point &upper = is_down ? *from : to, &lower = is_down ? to : *from;
    from = &to;
    if (upper.y == lower.y) continue;
    edges_.push_back(
        {upper.x, upper.y, lower.x, lower.y, (lower.x - upper.x) / (lower.y - upper.y), is_down ? -1.0 : 1.0});
  }
}

void ShadowRaster::sort() {
  const auto rows = static_cast<std::size_t>(rows_);
  const auto span_of = [&](const Edge& edge) {
    const auto top = static_cast<std::size_t>(std::clamp(std::floor(edge.y0), 0.0, rows_ - 1.0));
    const auto bottom = static_cast<std::size_t>(std::clamp(std::floor(edge.y1), 0.0, rows_ - 1.0));
    return std::pair{top, bottom};
  };
  first_.assign(rows + 2, 0);
  for (const Edge& edge : edges_) {
    const auto [top, bottom] = span_of(edge);
    for (std::size_t j = top; j <= bottom; ++j) ++first_[j + 2];
  }
  for (std::size_t j = 2; j < first_.size(); ++j) first_[j] += first_[j - 1];
  order_.resize(first_.back());
  for (std::uint32_t k = 0; k < edges_.size(); ++k) {
    const auto [top, bottom] = span_of(edges_[k]);
    for (std::size_t j = top; j <= bottom; ++j) order_[first_[j + 1]++] = k;
  }
}

void ShadowRaster::gather(int j) {
  const auto row = static_cast<std::size_t>(j);
  for (std::uint32_t k = first_[row]; k < first_[row + 1]; ++k) {
    const Edge& edge = edges_[order_[k]];
    if (is_by_area_) {
      cover(edge, j);
      continue;
    }
    const double middle = j + 0.5;
    if (!(edge.y0 <= middle && middle < edge.y1)) continue;
    const double x = edge.x0 + (middle - edge.y0) * edge.slope;
    change(static_cast<int>(std::clamp(std::ceil(x - 0.5), 0.0, static_cast<double>(columns_))), edge.sign);
  }
}

void ShadowRaster::cover(const Edge& edge, int j) {
  const double top = std::max<double>(edge.y0, j), bottom = std::min<double>(edge.y1, j + 1);
  if (!(bottom > top)) return;
  const auto at = [&](double y) {
    const double x = y <= edge.y0 ? edge.x0 : y >= edge.y1 ? edge.x1 : edge.x0 + (y - edge.y0) * edge.slope;
    return std::clamp(x, 0.0, static_cast<double>(columns_));
  };
  const double here = at(top), there = at(bottom);
  const double low = std::min(here, there), high = std::max(here, there);
  const double height = edge.sign * (bottom - top);
  const double per_width = high > low ? height / (high - low) : 0;
  // From cell to cell; each gets what lies right of the edge within it, the rest falls to all cells beyond.
  int cell = static_cast<int>(low);
  for (double from = low;; ++cell) {
    const double to = std::min<double>(high, cell + 1);
    const double share = high > low ? (to - from) * per_width : height;
    const double beyond = share * (0.5 * (from + to) - cell);
    change(cell, share - beyond);
    change(cell + 1, beyond);
    if (to >= high) break;
    from = to;
  }
}

}  // namespace shadow_planes
