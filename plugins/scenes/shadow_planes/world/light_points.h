// Points of a light, as samples ask for them.
#pragma once

#include <vector>

#include "world/world.h"

namespace shadow_planes {

class LightPoints {
 public:
  explicit LightPoints(const Light& light);

  // Of an area light: where (u, v) in [0, 1) x [0, 1) lies; equal areas stand for equal areas of the light. On a
  // parallelogram u goes along its first side and v along its last. Any other polygon is a fan around its first corner:
  // u goes round, v outward. Of a point light: that point. Of a directional light: the direction, with w = 0.
  Homogeneous at(double u, double v) const;
  double area() const { return area_; }

 private:
  // Corner `from`; the shares of u up to `end` fall to it.
  struct Piece {
    Vector from, first, second;  // sides
    bool is_parallelogram;
    double end;
  };

  std::vector<Piece> pieces_;
  Homogeneous only_{};
  double area_ = 0;
};

}  // namespace shadow_planes
