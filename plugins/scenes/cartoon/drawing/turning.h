// Rotations by degrees, exact where sine and cosine are.
#pragma once

#include <cmath>
#include <numbers>

namespace cartoon {

struct Turning {
  double sine = 0, cosine = 1;
};

// By right angles without rounding, so that upright edges stay upright. Requires: a finite angle.
inline Turning turning_of(double degrees) {
  const double quarters = std::nearbyint(degrees / 90);
  const double rest = (degrees - 90 * quarters) * (std::numbers::pi / 180);  // -45 .. 45 degrees
  const double s = std::sin(rest), c = std::cos(rest);
  switch (static_cast<int>(std::fmod(quarters, 4) + 4) % 4) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

}  // namespace cartoon
