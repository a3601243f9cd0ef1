// What lies below a straight edge.
#pragma once

#include <algorithm>

namespace area {

// v within 0 .. 1. In this order of maximum and minimum it takes no branch, which pixels would have guessed wrong.
inline double clamped(double v) { return std::min(1.0, std::max(0.0, v)); }

// The mean of a ramp from a to b where it is cut off below 0 and above 1: how much of a unit square's stretch lies
// below an edge whose heights at the stretch's ends are a and b. No two numbers of like size are subtracted, however
// steep or flat the ramp is.
inline double covered(double a, double b) {
  const double low = std::min(a, b), high = std::max(a, b), rise = high - low;
  const double low_inside = clamped(low), high_inside = clamped(high);
  if (!(rise > 0)) return low_inside;
  // The part between 0 and 1, times its mean, and the part above.
  const double inside = (high_inside - low_inside) * (low_inside + high_inside) / 2;
  return (inside + std::max(high - std::max(low, 1.0), 0.0)) / rise;
}

}  // namespace area
