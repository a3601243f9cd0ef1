// Lambert's sum over the edges of polygons in the plane z = 0, seen from a point above it.
#pragma once

#include <array>
#include <cstddef>

#include <moire/geometry.h>

#include "world/space.h"

namespace shadow_planes {

class EdgeSum {
 public:
  // From p on a surface with this normal. Requires: p.z > 0.
  void begin(Vector p, Vector normal) {
    p_ = p;
    normal_ = normal;
    sum_ = 0;
    count_ = 0;
  }
  // Adds the irradiance of a polygon of radiance 1 whose area is positive.
  void add(const moire::Point* corners, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) edge(corners[k], corners[k + 1 < count ? k + 1 : 0]);
  }
  void subtract(const moire::Point* corners, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) edge(corners[k + 1 < count ? k + 1 : 0], corners[k]);
  }
  double total() {
    flush();
    return -0.5 * sum_;
  }

 private:
  static constexpr std::size_t most = 32;

  // An edge by where it begins, seen from p, and its own extent, which does not lose digits to the point's distance.
  void edge(const moire::Point& from, const moire::Point& to) {
    if (count_ == most) flush();
    rx_[count_] = from.x - p_.x, ry_[count_] = from.y - p_.y;
    ex_[count_] = to.x - from.x, ey_[count_] = to.y - from.y;
    ++count_;
  }
  void flush();

  Vector p_, normal_;
  double sum_ = 0;
  std::size_t count_ = 0;
  std::array<double, most> rx_{}, ry_{}, ex_{}, ey_{};
};

}  // namespace shadow_planes
