#include "weights/square.h"

#include <algorithm>
#include <cmath>

#include "look.h"

namespace pattern {

double Square::along(moire::Point p, moire::Point q) {
  if (p.y == q.y) return 0;
  const double sign = p.y < q.y ? 1 : -1;
  if (sign < 0) std::swap(p, q);
  const double y0 = std::max(p.y, -0.5), y1 = std::min(q.y, 0.5);
  if (y0 >= y1) return 0;
  // below(x) is straight while x is in the square: its mean is that of the ends of that stretch.
  const double slope = (q.x - p.x) / (q.y - p.y);
  const double a = (y0 > p.y ? p.x + (y0 - p.y) * slope : p.x) + 0.5;
  const double b = (y1 < q.y ? p.x + (y1 - p.y) * slope : q.x) + 0.5;
  const double low = std::min(a, b), high = std::max(a, b);
  if (high <= 0) return 0;
  if (low >= 1) return sign * (y1 - y0);
  if (low >= 0 && high <= 1) return sign * (y1 - y0) * (low + high) / 2;
  const double from = std::max(low, 0.0), to = std::min(high, 1.0);
  return sign * (y1 - y0) * (((to - from) * (from + to) / 2 + (high - to)) / (high - low));
}

namespace {

// t - sin t, t from 0 to pi.
double angle_less_sine(double t) {
  if (t > 0.3) return t - std::sin(t);
  // Its series: the next term is less than 2e-17 of the first.
  const double s = t * t;
  return t * s / 6 * (1 - s / 20 * (1 - s / 42 * (1 - s / 72 * (1 - s / 110 * (1 - s / 156)))));
}

// The upper half of a disk about (0, 0), of radius r: the area in it and in u0 < u < u1, v0 < v < v1, v upward.
double half_disk(double r, double u0, double u1, double v0, double v1) {
  v0 = std::max(v0, 0.0);
  if (v0 >= v1 || v0 >= r) return 0;
  const auto half_chord = [r](double v) { return v < r ? std::sqrt((r - v) * (r + v)) : 0; };
  // Where the circle is above v0, and where it is above v1.
  const double wide = half_chord(v0), narrow = half_chord(v1);
  // Between it and v0, where it is between v0 and v1: a trapezium, and the segment of the disk above its chord.
  const auto under_arc = [&](double from, double to) {
    from = std::max(from, u0), to = std::min(to, u1);
    if (from >= to) return 0.0;
    const moire::Point p{from, half_chord(std::abs(from))}, q{to, half_chord(std::abs(to))};
    const double turn = std::atan2(std::abs(cross(p, q)), dot(p, q));
    const double chords = ((p.y - v0) + (q.y - v0)) / 2;
    return (to - from) * chords + r * r / 2 * angle_less_sine(turn);
  };
  const double full = std::min(narrow, u1) - std::max(-narrow, u0);
  return under_arc(-wide, -narrow) + std::max(full, 0.0) * (v1 - v0) + under_arc(narrow, wide);
}

}  // namespace

double Square::disk(moire::Point middle, double r) {
  const double u0 = -0.5 - middle.x, u1 = 0.5 - middle.x, v0 = -0.5 - middle.y, v1 = 0.5 - middle.y;
  const double near_x = std::max({u0, -u1, 0.0}), near_y = std::max({v0, -v1, 0.0});
  if (near_x * near_x + near_y * near_y >= r * r) return 0;
  const double far_x = std::max(-u0, u1), far_y = std::max(-v0, v1);
  if (far_x * far_x + far_y * far_y <= r * r) return 1;
  return std::min(half_disk(r, u0, u1, v0, v1) + half_disk(r, u0, u1, -v1, -v0), 1.0);
}

}  // namespace pattern
