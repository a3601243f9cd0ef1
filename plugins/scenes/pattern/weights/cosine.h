// The cosine, for many arguments at once.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

namespace pattern {

// cos(2 pi t) by the sine's series about the nearest zero: a sum without branches that compilers turn into vectors, of
// the same bits on every machine; the first term left out is 4e-18. Requires: |t| < 2^50.
inline double cosine(double t) {
  constexpr double whole = 0x1.8p52;  // what is added to it is rounded to an integer
  const double rest = 0.25 - std::abs(t - ((t + whole) - whole));
  const double x = 2 * std::numbers::pi * rest, s = x * x;
  constexpr std::array divisors{20 * 21.0, 18 * 19.0, 16 * 17.0, 14 * 15.0, 12 * 13.0,
                                10 * 11.0, 8 * 9.0,   6 * 7.0,   4 * 5.0,   2 * 3.0};
  double sum = 1;
  for (const double d : divisors) sum = 1 - s * (1 / d) * sum;
  return x * sum;
}

}  // namespace pattern
