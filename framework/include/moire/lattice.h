// Lattices of two dimensions that fill the unit square evenly whatever their number of points.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <moire/geometry.h>

namespace moire {

// In [0, 1): rounding to float may reach 1.
inline float fraction(double x) { return std::min(static_cast<float>(x - std::floor(x)), 0x1.fffffep-1F); }

// The k-th point of the R2 lattice, which begins at (u, v): steps of 1 / g and 1 / g^2, g^3 = g + 1 (Roberts 2018, "The
// Unreasonable Effectiveness of Quasirandom Sequences").
inline LightPoint r2_lattice(double u, double v, std::uint64_t k) {
  constexpr double g = 1.32471795724474602596;
  const auto steps = static_cast<double>(k);
  return {fraction(u + steps / g), fraction(v + steps / (g * g))};
}

// The k-th of `count` points of Fibonacci's lattice, as of any count: even steps, and steps of the golden ratio.
inline LightPoint fibonacci_lattice(std::uint64_t k, std::uint64_t count) {
  constexpr double golden = 0.61803398874989484820;
  const double steps = static_cast<double>(k) + 0.5;
  return {fraction(steps / static_cast<double>(count)), fraction(steps * golden)};
}

}  // namespace moire
