// Moments of a convex outline, and the coordinates in which those of second order are 1.
#pragma once

#include "seeing/outline.h"

namespace shadow_planes {

struct OutlineMoments {
  double area = 0;
  moire::Point centroid;
  // (x, y) = centroid + (xu u, yu u + yv v); the means of u^2 and v^2 over the outline are 1, that of u v is 0.
  double xu = 0, yu = 0, yv = 0;
  // Means over the outline of r^3 times the cosine and sine of the angle, and of three times it, in (u, v).
  double cos1 = 0, sin1 = 0, cos3 = 0, sin3 = 0;

  moire::Point at(double u, double v) const { return {centroid.x + xu * u, centroid.y + yu * u + yv * v}; }
};

// Requires: at least three corners. One that is flat to rounding has no third moments, and points on its centroid.
OutlineMoments moments_of(const Outline& outline);

}  // namespace shadow_planes
