// Angles under which edges are seen, for Lambert's sum over the edges of a polygon.
#pragma once

#include <cmath>
#include <numbers>

namespace shadow_planes {

// tan^2(pi / 8).
inline constexpr double steep_squared = 0.17157287525380990;

// atan(t) / t of t^2 = z in 0 .. tan^2(pi / 8), to an ulp: a polynomial of degree 11 through that many Chebyshev points
// (mpmath's chebyfit; its own error is 1.3e-18). The library's arctangent may differ between machines in its last bit.
inline double arctangent_ratio(double z) {
  constexpr double c[] = {1.0,
                          -0.3333333333333312,
                          0.19999999999940893,
                          -0.14285714279250245,
                          0.11111110744919658,
                          -0.09090896809064027,
                          0.07692045330902225,
                          -0.06662951813629191,
                          0.05846878297330872,
                          -0.05035102456601552,
                          0.03796525745386593,
                          -0.017805397205419446};
  // Estrin's order: short chains of dependent products.
  const double z2 = z * z, z4 = z2 * z2;
  const double low = (c[0] + c[1] * z) + (c[2] + c[3] * z) * z2;
  const double middle = (c[4] + c[5] * z) + (c[6] + c[7] * z) * z2;
  const double high = (c[8] + c[9] * z) + (c[10] + c[11] * z) * z2;
  return low + z4 * (middle + z4 * high);
}

// atan(t). Requires: t >= 0; infinity is allowed.
inline double arctangent(double t) {
  constexpr double tan_eighth = 0.41421356237309503, tan_three_eighths = 2.4142135623730949;
  if (t <= tan_eighth) return t * arctangent_ratio(t * t);
  if (t >= tan_three_eighths) return std::numbers::pi / 2 - arctangent_ratio(1 / (t * t)) / t;
  const double u = (t - 1) / (t + 1);
  return std::numbers::pi / 4 + u * arctangent_ratio(u * u);
}

// The angle between two vectors over the length of their cross product, from the square of that length and from their
// dot product. 0 for opposite vectors, whose cross product the caller multiplies with it: an edge seen end to end from
// a point on it brings nothing.
inline double angle_over_sine(double cross_squared, double dot) {
  if (dot > 0 && cross_squared <= steep_squared * dot * dot) {
    const double inverse = 1 / dot;
    return inverse * arctangent_ratio(inverse * inverse * cross_squared);
  }
  if (!(cross_squared > 0)) return 0;
  const double sine = std::sqrt(cross_squared), product = std::sqrt(cross_squared + dot * dot);
  // The tangent of half the angle, without a difference of near numbers.
  const double half = dot >= 0 ? sine / (product + dot) : (product - dot) / sine;
  return 2 * arctangent(half) / sine;
}

}  // namespace shadow_planes
