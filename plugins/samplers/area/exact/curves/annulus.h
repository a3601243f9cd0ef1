// A ring or a disk: its area in each pixel, chord by chord, and its circles as a pixel sees them.
//
// Within a quarter of the plane around the centre a circle falls from one axis to the other, so that it crosses a pixel
// once: what lies inside is a trapezoid below the chord and the segment between chord and arc. Where the circle
// crosses a pixel's side is counted from a corner, as the corner's excess r^2 - x^2 - y^2 over a sum of like signs. The
// excess is exact in its whole part: nothing of the size of r^2 is ever rounded.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include <moire/curves.h>
#include <moire/tally.h>

#include "exact/curves/arc.h"
#include "exact/curves/local_shapes.h"
#include "exact/curves/pair.h"
#include "exact/curves/ramp.h"
#include "exact/curves/whole.h"

namespace area {

// A circle's radius, as a whole number and the rest.
class Radius {
 public:
  Radius(double whole, double rest)
      : value_(whole + rest),
        inverse_(1 / value_),
        whole_square_(whole * whole),
        rest_of_square_(2 * whole * rest + rest * rest) {}

  double value() const { return value_; }
  double inverse() const { return inverse_; }
  double whole_square() const { return whole_square_; }
  double rest_of_square() const { return rest_of_square_; }

 private:
  double value_, inverse_, whole_square_, rest_of_square_;
};

class Annulus {
 public:
  explicit Annulus(const moire::CircleCurve& circle);
  // The disk around a point.
  Annulus(moire::Point center, double radius);

  // True: no width.
  bool is_empty() const { return !outer_; }

  // Calls put(x, y, area) for the pixels of `clip` that it touches and some beside it, whose area is 0; the same to the
  // bit whatever `clip` is.
  template <class Put>
  void areas(const moire::PixelArea& clip, Put put) const;

  // Calls put(box) for boxes of the grid that together hold all pixels it touches, and few others.
  template <class Put>
  void boxes(int grid, const moire::PixelArea& boxes, Put put) const;

  // As pixel (x, y) sees them. Requires: not empty; has_hole().
  LocalDisk outer(int x, int y) const { return local(*outer_, x, y); }
  LocalDisk inner(int x, int y) const { return local(*inner_, x, y); }
  bool has_hole() const { return inner_.has_value(); }

  // All pixels it may touch.
  moire::PixelArea bounds(const moire::PixelArea& clip) const;

 private:
  // A border between pixels, or the centre: its distance from the centre and the distance's square.
  struct Border {
    double distance = 0, whole_square = 0, rest_of_square = 0;
  };
  // What two borders on one side of the centre have between them.
  struct Strip {
    Border near, far;
    double width;
  };
  // A row or column of pixels: one strip, or two where the centre lies in it.
  struct Strips {
    Strip strip[2];
    int count;
  };

  static Border border(double n, double fraction) {
    return {std::abs(n - fraction), n * n, fraction * (fraction - 2 * n)};
  }
  static Strips strips(double n, double fraction) {
    const Border low = border(n, fraction), high = border(n + 1, fraction);
    if (n == 0 && fraction > 0) return {{{{}, low, fraction}, {{}, high, 1 - fraction}}, 2};
    if (n < 0) return {{{high, low, 1}, {}}, 1};
    return {{{low, high, 1}, {}}, 1};
  }
  static double excess(const Radius& radius, const Border& x, const Border& y) {
    return (radius.whole_square() - x.whole_square - y.whole_square) +
           (radius.rest_of_square() - x.rest_of_square - y.rest_of_square);
  }
  static double area(const Radius& radius, const Strip& x, const Strip& y);
  static double area(const Radius& radius, const Strips& x, const Strips& y) {
    double sum = area(radius, x.strip[0], y.strip[0]);
    if (x.count == 2) sum += area(radius, x.strip[1], y.strip[0]);
    if (y.count == 2) sum += area(radius, x.strip[0], y.strip[1]);
    if (x.count == 2 && y.count == 2) sum += area(radius, x.strip[1], y.strip[1]);
    return sum;
  }
  // Half the width of a circle at a distance from its centre.
  static double half_width(const Radius& radius, double distance) {
    return distance < radius.value() ? std::sqrt((radius.value() - distance) * (radius.value() + distance)) : 0;
  }

  LocalDisk local(const Radius& radius, int x, int y) const {
    const double nx = x - column_, ny = y - row_;
    const Border bx = border(nx, x_), by = border(ny, y_);
    return {excess(radius, bx, by), x_ - nx, y_ - ny, radius.value()};
  }

  void keep_pairs();
  template <bool few_terms, class Put>
  void rows(const moire::PixelArea& clip, Put put) const;
  template <bool few_terms, class Put>
  void outward(int row, int column, int stop, int step, const Strip& y, Put put) const;

  double column_, row_, x_, y_;  // the centre: a pixel's corner, and what goes beyond it
  std::optional<Radius> outer_, inner_;
  Pair squares_, rests_, inverses_;  // of both radii; without a hole its square is negative
};

// Of the disk, in a rectangle to one side of both axes.
inline double Annulus::area(const Radius& radius, const Strip& x, const Strip& y) {
  const double near = excess(radius, x.near, y.near);
  if (near <= 0) return 0;
  if (excess(radius, x.far, y.far) >= 0) return x.width * y.width;
  // From p, where the circle comes in over the near side in x or the far one in y, to q, where it leaves over the far
  // side in x or the near one in y; both from the near corner.
  double px = 0, py = y.width, qx = x.width, qy = 0;
  const double above = excess(radius, x.near, y.far), beside = excess(radius, x.far, y.near);
  if (above <= 0) {
    py = near / (std::sqrt(near + y.near.distance * y.near.distance) + y.near.distance);
  } else {
    px = above / (std::sqrt(above + x.near.distance * x.near.distance) + x.near.distance);
  }
  if (beside <= 0) {
    qx = near / (std::sqrt(near + x.near.distance * x.near.distance) + x.near.distance);
  } else {
    qy = beside / (std::sqrt(beside + y.near.distance * y.near.distance) + y.near.distance);
  }
  const double dx = qx - px, dy = py - qy;
  return px * y.width + dx * (py + qy) / 2 + segment_area(dx * dx + dy * dy, radius.inverse());
}

template <class Put>
void Annulus::areas(const moire::PixelArea& clip, Put put) const {
  if (is_empty()) return;
  // A chord in a pixel is no longer than the root of 2: u of the series is below 2^-10 from this radius on.
  const double least = inner_ ? inner_->value() : outer_->value();
  if (least > 23) {
    rows<true>(clip, put);
  } else {
    rows<false>(clip, put);
  }
}

template <bool few_terms, class Put>
void Annulus::rows(const moire::PixelArea& clip, Put put) const {
  const moire::PixelArea all = bounds(clip);
  const double center = column_ + x_;
  // Circles that cross a row are looked for a little farther out, and holes a little farther in.
  const double margin = 0x1p-40 * (1 + outer_->value());
  const bool is_small = (inner_ ? inner_->value() : outer_->value()) < 5;
  for (int row = all.y0; row < all.y0 + all.height; ++row) {
    const Strips y = strips(row - row_, y_);
    const double nearest = y.strip[0].near.distance;
    const double farthest = std::max(y.strip[0].far.distance, y.strip[1].far.distance);
    const double reach = half_width(*outer_, nearest) + margin;
    const int first = std::max(all.x0, whole(std::floor(center - reach)));
    const int end = std::max(first, std::min(all.x0 + all.width, whole(std::ceil(center + reach))));
    // Columns that see the hole alone in this row.
    int hole = first, hole_end = first;
    if (inner_) {
      const double half = half_width(*inner_, farthest) - margin;
      if (half > 0) {
        hole = std::clamp(whole(std::ceil(center - half)), first, end);
        hole_end = std::clamp(whole(std::floor(center + half)), hole, end);
      }
    }
    const auto one_by_one = [&](int from, int to) {
      for (int column = from; column < to; ++column) {
        const Strips x = strips(column - column_, x_);
        double sum = area(*outer_, x, y);
        if (inner_ && sum > 0) sum -= area(*inner_, x, y);
        put(column, row, clamped(sum));
      }
    };
    if (is_small || y.count == 2) {
      one_by_one(first, hole);
      one_by_one(hole_end, end);
      continue;
    }
    // Outward from the centre, whose own column has two sides.
    const int left = std::clamp(whole(column_), first, end), right = std::clamp(whole(std::ceil(center)), first, end);
    const bool has_hole = hole < hole_end;
    outward<few_terms>(row, (has_hole ? std::min(hole, left) : left) - 1, first - 1, -1, y.strip[0], put);
    if (!has_hole || hole > left || hole_end < right) one_by_one(left, right);
    outward<few_terms>(row, has_hole ? std::max(hole_end, right) : right, end, 1, y.strip[0], put);
  }
}

// Both circles at once, from column to column: what is known of the border between two serves both.
template <bool few_terms, class Put>
void Annulus::outward(int row, int column, int stop, int step, const Strip& y, Put put) const {
  const Pair near_square = squares_ - Pair(y.near.whole_square), far_square = squares_ - Pair(y.far.whole_square);
  const Pair near_rest = rests_ - Pair(y.near.rest_of_square), far_rest = rests_ - Pair(y.far.rest_of_square);
  const auto border_at = [&](int n) { return border(n - column_, x_); };
  const auto excesses = [&](const Border& x, Pair& near, Pair& far) {
    const Pair square(x.whole_square), rest(x.rest_of_square);
    near = (near_square - square) + (near_rest - rest);
    far = (far_square - square) + (far_rest - rest);
  };
  // On a side of a corner: from the corner to the circle, whose side's distance from the centre is `across`.
  const auto length = [](Pair excess, Pair across) {
    return excess / (sqrt(max(excess + across * across, Pair())) + across);
  };
  const Pair one(1), none, y_near(y.near.distance);
  Border x = border_at(step > 0 ? column : column + 1);
  Pair corner, above, beside, beyond;
  excesses(x, corner, above);
  for (; column != stop; column += step) {
    const Border next = border_at(step > 0 ? column + 1 : column);
    excesses(next, beside, beyond);
    // As in area().
    const Pair x_near(x.distance);
    const Pair p_beside = above <= none, q_above = beside <= none;
    const Pair p = length(chosen(p_beside, corner, above), chosen(p_beside, y_near, x_near));
    const Pair q = length(chosen(q_above, corner, beside), chosen(q_above, x_near, y_near));
    const Pair px = chosen(p_beside, none, p), py = chosen(p_beside, p, one);
    const Pair qx = chosen(q_above, q, one), qy = chosen(q_above, none, q);
    const Pair dx = qx - px, dy = py - qy, chord_squared = dx * dx + dy * dy;
    const Pair segment = chord_squared * sqrt(chord_squared) * inverses_ * Pair(0.125) *
                         segment_series<few_terms>(chord_squared * (inverses_ * inverses_ * Pair(0.25)));
    const Pair inside = px + dx * (py + qy) * Pair(0.5) + segment;
    const Pair areas = chosen(corner <= none, none, chosen(none <= beyond, one, inside));
    put(column, row, clamped(areas.difference()));
    x = next, corner = beside, above = beyond;
  }
}

template <class Put>
void Annulus::boxes(int grid, const moire::PixelArea& boxes, Put put) const {
  if (is_empty()) return;
  const moire::PixelArea all = bounds({boxes.x0 * grid, boxes.y0 * grid, boxes.width * grid, boxes.height * grid});
  if (all.width <= 0 || all.height <= 0) return;
  const double x = column_ + x_, y = row_ + y_, outer = outer_->value() + 1, inner = inner_ ? inner_->value() - 1 : -1;
  for (int v = all.y0 / grid; v <= (all.y0 + all.height - 1) / grid; ++v) {
    for (int u = all.x0 / grid; u <= (all.x0 + all.width - 1) / grid; ++u) {
      const double left = u * grid - x, right = left + grid, top = v * grid - y, bottom = top + grid;
      const double near = std::hypot(std::max({left, -right, 0.0}), std::max({top, -bottom, 0.0}));
      const double far = std::hypot(std::max(-left, right), std::max(-top, bottom));
      if (near <= outer && far >= inner) put(u, v);
    }
  }
}

}  // namespace area
