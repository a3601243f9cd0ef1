// Points, directions and planes of space.
#pragma once

#include <cmath>

namespace shadow_planes {

struct Vector {
  double x = 0, y = 0, z = 0;

  friend constexpr Vector operator+(Vector p, Vector q) { return {p.x + q.x, p.y + q.y, p.z + q.z}; }
  friend constexpr Vector operator-(Vector p, Vector q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }
  friend constexpr Vector operator-(Vector p) { return {-p.x, -p.y, -p.z}; }
  friend constexpr Vector operator*(double f, Vector p) { return {f * p.x, f * p.y, f * p.z}; }
  friend constexpr bool operator==(const Vector&, const Vector&) = default;
};

constexpr double dot(Vector p, Vector q) { return p.x * q.x + p.y * q.y + p.z * q.z; }
constexpr Vector cross(Vector p, Vector q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}
inline double length(Vector p) { return std::sqrt(dot(p, p)); }

// A point (w = 1 after division), or a direction (w = 0).
struct Homogeneous {
  double x = 0, y = 0, z = 0, w = 1;
};

// G = (n, d) with |n| = 1: P.G is how far P lies from the plane, on the side that n points to.
struct Plane {
  Vector normal{0, 0, 1};
  double d = 0;

  constexpr double distance(Vector p) const { return dot(normal, p) + d; }
  constexpr double of(const Homogeneous& p) const { return normal.x * p.x + normal.y * p.y + normal.z * p.z + d * p.w; }
};

}  // namespace shadow_planes
