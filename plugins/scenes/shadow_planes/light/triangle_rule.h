// Quadrature over triangles.
#pragma once

#include <array>

namespace shadow_planes {

// A point of a triangle by its weights of the corners, and its share of the area.
struct TrianglePoint {
  double a, b, c, weight;
};

// Radon's rule of 7 points, exact for polynomials of degree 5 (Radon 1948, "Zur mechanischen Kubatur").
inline constexpr std::array<TrianglePoint, 7> seven_points = [] {
  // (6 -+ sqrt 15) / 21 and (155 -+ sqrt 15) / 1200.
  constexpr double near = 0.10128650732345634, far = 0.47014206410511505;
  constexpr double near_weight = 0.12593918054482717, far_weight = 0.13239415278850616;
  return std::array<TrianglePoint, 7>{{{1.0 / 3, 1.0 / 3, 1.0 / 3, 0.225},
                                       {near, near, 1 - 2 * near, near_weight},
                                       {near, 1 - 2 * near, near, near_weight},
                                       {1 - 2 * near, near, near, near_weight},
                                       {far, far, 1 - 2 * far, far_weight},
                                       {far, 1 - 2 * far, far, far_weight},
                                       {1 - 2 * far, far, far, far_weight}}};
}();

}  // namespace shadow_planes
