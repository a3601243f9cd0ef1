// Places in the cells of a grid.
#pragma once

#include <algorithm>
#include <cstdint>

namespace moire {

// A place in cell `cell` of n equal ones in [0, 1): its middle at amount 0, anywhere in it at amount 1. `u`: a uniform
// number in [0, 1).
inline double jittered(std::int64_t cell, std::int64_t n, double amount, double u) {
  const double middle = static_cast<double>(cell) + 0.5;
  if (amount == 0) return middle / static_cast<double>(n);
  // Rounding must not carry it into the next cell.
  constexpr double below_one = 1 - 0x1p-53;
  return std::min(middle + amount * (u - 0.5), (middle + 0.5) * below_one) / static_cast<double>(n);
}

}  // namespace moire
