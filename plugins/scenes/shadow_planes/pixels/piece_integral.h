// Integrals over convex pieces of a pixel within which irradiance is smooth, or nearly so.
#pragma once

#include "pixels/gathered.h"

namespace shadow_planes {

struct Integral {
  Sums sums;
  double error = 0;  // of sums.light, estimated
};

class PieceIntegral {
 public:
  // `tolerance`: of Sums::light, per unit of area.
  PieceIntegral(const SeenFace& face, double tolerance, Gatherer& gatherer)
      : face_(face), tolerance_(tolerance), gatherer_(gatherer) {}

  // Over a convex outline: as a whole, and if that is not good enough in triangles, divided again where needed.
  // `contact`: a corner around which irradiance depends on the direction, or null.
  Integral over(const Outline& outline, const moire::Point* contact, std::span<const std::uint32_t> candidates);

 private:
  struct Triangle {
    moire::Point a, b, c;
    double area() const;
  };

  Integral whole(const Outline& outline, std::span<const std::uint32_t> candidates);
  Integral triangle(const Triangle& triangle, std::span<const std::uint32_t> candidates, int depth);
  Integral around(const Triangle& triangle, std::span<const std::uint32_t> candidates, int depth);
  double seen_in_corners(std::span<const moire::Point> corners, moire::Point inside);
  Integral collapsed(const Triangle& triangle, std::span<const std::uint32_t> candidates);
  bool is_good(const Integral& integral, double area) const;

  const SeenFace& face_;
  double tolerance_;
  Gatherer& gatherer_;
  std::vector<std::uint32_t> met_;
};

}  // namespace shadow_planes
