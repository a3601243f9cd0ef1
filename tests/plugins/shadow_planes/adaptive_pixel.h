// Pixels by adaptive quadrature that knows of no critical line.
#pragma once

#include <cmath>
#include <memory>

#include "light/illumination.h"
#include "seeing/camera.h"

namespace shadow_planes::test {

// Of the radiance of face 0 over the square around (x, y), by Gauss's 3 x 3 points, divided while quarters disagree.
class AdaptivePixel {
 public:
  AdaptivePixel(const World& world, const Camera& camera)
      : camera_(camera), illumination_(illumination_of(world, 0, world.faces[0].plane)) {}

  struct Result {
    double value, squared_error;
  };
  Result over(double x, double y, double side, double tolerance, int depth = 0) {
    return refined(x, y, side, tolerance, depth, rule(x, y, side));
  }

 private:
  // A cut corner that no point of a coarse grid sees must not look smooth.
  static constexpr int smallest = 4, largest = 11;

  Result refined(double x, double y, double side, double tolerance, int depth, double whole) {
    const double half = side / 2;
    double parts[4], sum = 0;
    for (int k = 0; k < 4; ++k) {
      parts[k] = rule(x + (k % 2) * half, y + (k / 2) * half, half);
      sum += parts[k];
    }
    const double difference = std::abs(sum - whole);
    if ((difference <= tolerance && depth >= smallest) || depth == largest) return {sum, difference * difference};
    Result result{0, 0};
    for (int k = 0; k < 4; ++k) {
      const Result part = refined(x + (k % 2) * half, y + (k / 2) * half, half, tolerance / 3, depth + 1, parts[k]);
      result = {result.value + part.value, result.squared_error + part.squared_error};
    }
    return result;
  }
  double rule(double x, double y, double side) {
    const double off = 0.5 * std::sqrt(0.6);
    double sum = 0;
    for (int i = -1; i <= 1; ++i) {
      for (int j = -1; j <= 1; ++j) {
        sum += (i ? 5 : 8) * (j ? 5 : 8) * at(x + side * (0.5 + i * off), y + side * (0.5 + j * off));
      }
    }
    return sum / 324 * side * side;
  }
  double at(double x, double y) {
    const Vector ray = camera_.ray({x, y});
    const Vector p = camera_.eye - (camera_.eye.z / ray.z) * ray;
    return illumination_->at(p, illumination_->all(), scratch_).irradiance;
  }

  Camera camera_;
  std::unique_ptr<const Illumination> illumination_;
  Illumination::Scratch scratch_;
};

// To see the receiver through the casters.
inline World only_receiver(const World& world) {
  World result = world;
  result.faces.resize(1);
  return result;
}

}  // namespace shadow_planes::test
