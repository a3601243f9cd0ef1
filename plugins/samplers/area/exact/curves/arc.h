// The area between a circle's arc and its chord.
#pragma once

#include <cmath>

namespace area {

// With s = sin(angle / 2) = chord / (2 r) the area is
//   r^2 (asin s - s sqrt(1 - s^2)) = chord^3 / (8 r) (2/3 + s^2 / 5 + 3 s^4 / 28 + ...),
// twice the integral of s^2 / sqrt(1 - s^2), whose series loses nothing to the r^2 that would cancel. Square roots and
// the four operations are all it takes, so that the bits are the same on every machine.

// The sum in brackets, of u = s^2: the k-th term is 2 C(2k, k) / (4^k (2k + 3)) u^k. What is left out is below 2^-53.
// Requires: u <= 2^-5; with `few` terms, u <= 2^-10.
template <bool few, class Number>
Number segment_series(Number u) {
  const auto next = [&u](Number sum, double term) { return sum * u + Number(term); };
  Number sum(35.0 / 704);
  if constexpr (!few) {
    sum = Number(46189.0 / 262144 / 23 * 2);
    sum = next(sum, 12155.0 / 65536 / 21 * 2);
    sum = next(sum, 6435.0 / 32768 / 19 * 2);
    sum = next(sum, 429.0 / 2048 / 17 * 2);
    sum = next(sum, 231.0 / 1024 / 15 * 2);
    sum = next(sum, 63.0 / 256 / 13 * 2);
    sum = next(sum, 35.0 / 704);
  }
  sum = next(sum, 5.0 / 72);
  sum = next(sum, 3.0 / 28);
  sum = next(sum, 1.0 / 5);
  return next(sum, 2.0 / 3);
}

// Of an arc of at most half the circle. Where the series converges slowly the arc is halved, which leaves a triangle
// and two smaller segments.
inline double segment_area(double chord_squared, double inverse_radius) {
  const double u = chord_squared * inverse_radius * inverse_radius / 4;
  const double chord = std::sqrt(chord_squared);
  if (u > 0x1p-5) {
    const double deep = 1 + std::sqrt(std::fmax(1 - u, 0.0));
    const double sagitta = chord_squared * inverse_radius / (4 * deep);
    return chord * sagitta / 2 + 2 * segment_area(chord_squared / (2 * deep), inverse_radius);
  }
  const double sum = u > 0x1p-10 ? segment_series<false>(u) : segment_series<true>(u);
  return chord_squared * chord * inverse_radius / 8 * sum;
}

}  // namespace area
