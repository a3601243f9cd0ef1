// The rectangle of a line with width: its area in each pixel in closed form, and its edges as a pixel sees them.
//
// Along the axis in which the line is longer, most columns of pixels see only its two long edges. In them a pixel's
// area is a difference of means of ramps over the column: with the height of the lower end of an edge above a pixel's
// border, and its rise over the column, the mean of what lies above the border is that height plus half the rise, or a
// square over twice the rise where the edge crosses the border, or 0. Columns that touch an end sum all edges there.
//
// Heights are counted from each pixel's own border. For that the slope is kept as two numbers, of which the first has
// so few digits that its multiples are exact.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <moire/curves.h>
#include <moire/tally.h>

#include "exact/curves/local_shapes.h"
#include "exact/curves/pair.h"
#include "exact/curves/ramp.h"
#include "exact/curves/whole.h"

namespace area {

class Stroke {
 public:
  // Caps are butt or square here; a line of round ones is given without them. A line without length has, with square
  // caps, the square whose sides lie along the axes.
  explicit Stroke(const moire::LineCurve& line);

  // True: no length or no width.
  bool is_empty() const { return is_empty_; }

  // Calls put(x, y, area) for the pixels of `clip` that the rectangle touches and some beside it, whose area is 0; the
  // same to the bit whatever `clip` is.
  template <class Put>
  void areas(const moire::PixelArea& clip, Put put) const {
    if (is_empty_) return;
    if (is_steep_) {
      along(
          {clip.y0, clip.x0, clip.height, clip.width}, [&](int u, int v, double area)
                                                           __attribute__((always_inline)) { put(v, u, area); });
    } else {
      along(clip, put);
    }
  }

  // The four sides, as pixel (x, y) sees them. Requires: not empty.
  std::array<HalfPlane, 4> sides(int x, int y) const;

  // Calls put(box) for boxes of the grid that together hold all pixels it touches, and few others.
  // `grid` is the side of a box in pixels, `boxes` says which ones there are.
  template <class Put>
  void boxes(int grid, const moire::PixelArea& boxes, Put put) const {
    if (is_empty_) return;
    if (is_steep_) {
      boxes_along(grid, {boxes.y0, boxes.x0, boxes.height, boxes.width}, [&](int u, int v) { put(v, u); });
    } else {
      boxes_along(grid, boxes, put);
    }
  }

 private:
  // u is the axis in which the line is longer, v the other.
  // A point as the corner of a pixel and what goes beyond it.
  struct Place {
    double column = 0, row = 0;
    double u = 0, v = 0;
  };
  // A side between u = from and u = to, through (u0, v0), counted from a Place; `sign` is 1 where the area between it
  // and v = -infinity counts, -1 where it is taken away.
  struct Edge {
    double from, to, u0, v0, slope, sign;
    double at(double u) const { return v0 + (u - u0) * slope; }
  };
  // Which of the edges lie in one column, and between what heights.
  struct Stretch {
    double a, b, weight;
  };

  static Place place(long double u, long double v);
  void make_edges(double du, double dv, long double length);

  // The height of the middle line at u = column above v = row.
  double middle(double column, double row) const {
    const double n = column - anchor_.column;
    return (coarse_slope_ * n - (row - anchor_.row)) + (fine_slope_ * n + anchor_.v);
  }

  template <class Put>
  void along(const moire::PixelArea& clip, Put put) const;
  template <class Put>
  void inner_columns(int first, int end, const moire::PixelArea& clip, Put put) const;
  template <class Put>
  void wide_columns(int first, int end, const moire::PixelArea& clip, Put put) const;
  template <class Put>
  void end_columns(int first, int end, const Place& origin, std::span<const Edge> edges, const moire::PixelArea& clip,
                   Put put) const;
  template <class Put>
  void boxes_along(int grid, const moire::PixelArea& boxes, Put put) const;

  bool is_empty_ = true, is_steep_ = false;
  Place anchor_;                              // of the middle line; its u is 0
  double coarse_slope_ = 0, fine_slope_ = 0;  // of v over u
  double slope_ = 0, rise_ = 0;               // their sum, and its absolute value
  double level_rise_ = 0;                     // of a level line, one so small that it is lost in any height
  double half_inverse_rise_ = 0;              // of that
  double half_height_ = 0;                    // of the strip, along v
  Place ends_[2];
  double left_ = 0, right_ = 0;                     // of the whole rectangle along u
  double inner_left_ = 0, inner_right_ = 0;         // columns that lie between them see no end
  Edge start_[3] = {}, end_[3] = {}, all_[4] = {};  // seen from the end they lie at, and from the first
};

template <class Put>
void Stroke::along(const moire::PixelArea& clip, Put put) const {
  int first = std::max(clip.x0, whole(std::floor(left_)));
  int last = std::min(clip.x0 + clip.width, whole(std::ceil(right_)));
  // Where the strip passes the clip's rows, and some columns more.
  if (rise_ > 0x1p-20) {
    const double top = (clip.y0 - anchor_.row - anchor_.v - half_height_) / slope_;
    const double bottom = (clip.y0 + clip.height - anchor_.row - anchor_.v + half_height_) / slope_;
    first = std::max(first, whole(std::floor(std::min(top, bottom)) + anchor_.column - 3));
    last = std::min(last, whole(std::ceil(std::max(top, bottom)) + anchor_.column + 3));
  }
  if (first >= last) return;
  const int inner = std::clamp(whole(inner_left_), first, last), outer = std::clamp(whole(inner_right_), first, last);
  if (inner_left_ < inner_right_) {
    end_columns(first, inner, ends_[0], start_, clip, put);
    inner_columns(inner, outer, clip, put);
    end_columns(outer, last, ends_[1], end_, clip, put);
  } else {
    end_columns(first, last, ends_[0], all_, clip, put);
  }
}

template <class Put>
void Stroke::inner_columns(int first, int end, const moire::PixelArea& clip, Put put) const {
  const double lower_end = std::min(slope_, 0.0), height = 2 * half_height_;
  if (height > 2) return wide_columns(first, end, clip, put);
  const auto put_in = [&](int column, int row, double area) __attribute__((always_inline)) {
    if (static_cast<unsigned>(row - clip.y0) < static_cast<unsigned>(clip.height)) put(column, row, clamped(area));
  };
  // The mean over the column of what an edge rises above a border, from its lower end's height: the mean of its heights
  // at the ends of the part above, times that part. A choice between cases would cost more than all the arithmetic.
  const auto above = [rise = Pair(level_rise_), half_inverse = Pair(half_inverse_rise_)](Pair low) {
    const Pair high = max(low + rise, Pair());
    return (high + max(low, Pair())) * (min(high, rise) * half_inverse);
  };
  // At the most so many rows; a little upwards, so that rounding leaves out none.
  const int rows = static_cast<int>(std::ceil(height + rise_)) + 1;
  const double up = lower_end - half_height_ - 0x1p-30;
  for (int column = first; column < end; ++column) {
    const double n = column - anchor_.column, coarse = coarse_slope_ * n, fine = fine_slope_ * n + anchor_.v;
    const double top = std::floor(coarse + fine + up);
    if (!(std::abs(top + anchor_.row) < far_off)) continue;
    const int row = static_cast<int>(top + anchor_.row);
    const double low = (coarse - top) + fine + lower_end;
    Pair edges(low + half_height_, low - half_height_);
    double before = height;
    for (int k = 0; k < rows; ++k) {
      edges = edges - Pair(1);
      const double after = above(edges).difference();
      put_in(column, row + k, before - after);
      before = after;
    }
  }
}

// Both edges are more than a row apart: sums of what they leave above each border would be large.
template <class Put>
void Stroke::wide_columns(int first, int end, const moire::PixelArea& clip, Put put) const {
  for (int column = first; column < end; ++column) {
    const double low = middle(column, 0) + std::min(slope_, 0.0);
    const int row_first = std::max(clip.y0, whole(std::floor(low - half_height_ - 0x1p-30)));
    const int row_end = std::min(clip.y0 + clip.height, whole(std::ceil(low + rise_ + half_height_ + 0x1p-30)));
    for (int row = row_first; row < row_end; ++row) {
      const double low_here = middle(column, row) + std::min(slope_, 0.0);
      const double upper = low_here + half_height_, lower = low_here - half_height_;
      put(column, row, covered(upper, upper + rise_) - covered(lower, lower + rise_));
    }
  }
}

template <class Put>
void Stroke::end_columns(int first, int end, const Place& origin, std::span<const Edge> edges,
                         const moire::PixelArea& clip, Put put) const {
  for (int column = first; column < end; ++column) {
    const double left = column - origin.column;
    Stretch stretches[4];
    int count = 0;
    double low = far_off, high = -far_off;
    for (const Edge& edge : edges) {
      const double from = std::max(edge.from, left), to = std::min(edge.to, left + 1);
      if (from >= to) continue;
      const double a = edge.at(from), b = edge.at(to);
      stretches[count++] = {a, b, edge.sign * (to - from)};
      low = std::min({low, a, b}), high = std::max({high, a, b});
    }
    if (count == 0) continue;
    const int row_first = std::max(clip.y0, whole(std::floor(low - 0x1p-40) + origin.row));
    const int row_end = std::min(clip.y0 + clip.height, whole(std::ceil(high + 0x1p-40) + origin.row));
    for (int row = row_first; row < row_end; ++row) {
      const double top = row - origin.row;
      double area = 0;
      for (int k = 0; k < count; ++k) {
        area += stretches[k].weight * covered(stretches[k].a - top, stretches[k].b - top);
      }
      put(column, row, clamped(area));
    }
  }
}

template <class Put>
void Stroke::boxes_along(int grid, const moire::PixelArea& boxes, Put put) const {
  const double side = grid;
  const int first = std::max(boxes.x0, whole(std::floor(left_ / side)));
  const int last = std::min(boxes.x0 + boxes.width, whole(std::floor(right_ / side)) + 1);
  for (int u = first; u < last; ++u) {
    const double a = middle(std::clamp(u * side, left_, right_), 0);
    const double b = middle(std::clamp((u + 1) * side, left_, right_), 0);
    const double low = std::min(a, b) - half_height_ - 1, high = std::max(a, b) + half_height_ + 1;
    const int top = std::max(boxes.y0, whole(std::floor(low / side)));
    const int bottom = std::min(boxes.y0 + boxes.height, whole(std::floor(high / side)) + 1);
    for (int v = top; v < bottom; ++v) put(u, v);
  }
}

}  // namespace area
