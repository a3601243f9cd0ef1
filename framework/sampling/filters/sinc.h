// sin(pi x) / (pi x).
#pragma once

#include <cmath>
#include <numbers>

namespace moire {

inline double sinc(double x) {
  const double angle = std::numbers::pi * x;
  return angle == 0 ? 1 : std::sin(angle) / angle;
}

}  // namespace moire
