// Rotations by degrees.
#pragma once

#include <cmath>
#include <numbers>

namespace moire {

// (x, y) goes to (cosine x - sine y, sine x + cosine y): clockwise in images, whose y grows downward.
struct Turn {
  double cosine = 1, sine = 0;
};

// Exact at multiples of 90 degrees, equal components at odd ones of 45; no component is a negative zero.
// Requires: a finite angle.
inline Turn turn_of(double degrees) {
  int quarters = 0;
  const double rest = std::remquo(degrees, 90, &quarters);  // -45 .. 45
  const double angle = rest * (std::numbers::pi / 180), c = std::cos(angle);
  const double s = std::abs(rest) == 45 ? std::copysign(c, rest) : std::sin(angle) + 0.0;
  switch (quarters & 3) {
    case 0:
      return {c, s};
    case 1:
      return {0.0 - s, c};
    case 2:
      return {-c, 0.0 - s};
    default:
      return {s, -c};
  }
}

}  // namespace moire
