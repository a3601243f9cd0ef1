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

  // Calls put(x, y, area) for the pixels of `clip` that it touches, the same to the bit whatever `clip` is.
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

  double column_, row_, x_, y_;  // the centre: a pixel's corner, and what goes beyond it
  std::optional<Radius> outer_, inner_;
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
  const moire::PixelArea all = bounds(clip);
  const double center = column_ + x_;
  // Circles that cross a row are looked for a little farther out, and holes a little farther in.
  const double margin = 0x1p-40 * (1 + outer_->value());
  for (int row = all.y0; row < all.y0 + all.height; ++row) {
    const Strips y = strips(row - row_, y_);
    const double nearest = y.strip[0].near.distance;
    const double farthest =
        y.count == 2 ? std::max(y.strip[0].far.distance, y.strip[1].far.distance) : y.strip[0].far.distance;
    const double reach = half_width(*outer_, nearest) + margin;
    const int first = std::max(all.x0, whole(std::floor(center - reach)));
    const int end = std::min(all.x0 + all.width, whole(std::ceil(center + reach)));
    // Columns that see the hole alone in this row.
    int hole_first = end, hole_end = end;
    if (inner_) {
      const double hole = half_width(*inner_, farthest) - margin;
      if (hole > 0) {
        hole_first = std::clamp(whole(std::ceil(center - hole)), first, std::max(first, end));
        hole_end = std::clamp(whole(std::floor(center + hole)), hole_first, std::max(hole_first, end));
      }
    }
    const auto columns = [&](int from, int to) {
      for (int column = from; column < to; ++column) {
        const Strips x = strips(column - column_, x_);
        double sum = area(*outer_, x, y);
        if (inner_ && sum > 0) sum -= area(*inner_, x, y);
        if (sum > 0) put(column, row, std::min(sum, 1.0));
      }
    };
    columns(first, hole_first);
    columns(hole_end, end);
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
