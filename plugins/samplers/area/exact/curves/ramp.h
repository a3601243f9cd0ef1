// What lies below a straight edge.
#pragma once

#include <algorithm>

namespace area {

// The mean of a ramp from a to b where it is cut off below 0 and above 1: how much of a unit square's stretch lies
// below an edge whose heights at the stretch's ends are a and b. No two numbers of like size are subtracted, however
// steep or flat the ramp is.
inline double covered(double a, double b) {
  const double low = std::min(a, b), high = std::max(a, b);
  if (low >= 0) {
    if (high <= 1) return (low + high) / 2;
    return low >= 1 ? 1 : 1 - (1 - low) * (1 - low) / (2 * (high - low));
  }
  if (high <= 0) return 0;
  return (high <= 1 ? high * high / 2 : high - 0.5) / (high - low);
}

}  // namespace area
