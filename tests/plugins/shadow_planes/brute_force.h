// What rays see, one triangle after another in long doubles: no edges of the image, no trees, no projections.
#pragma once

#include <cstdint>
#include <optional>

#include <moire/random.h>
#include <moire/texture.h>

#include "seeing/camera.h"
#include "seeing/shadow_frame.h"
#include "world/world.h"

namespace moire::test {

// A sequence of random numbers.
class Randoms {
 public:
  explicit Randoms(std::uint64_t seed) : seed_(seed) {}
  double operator()(double low, double high) {
    return low + (high - low) * moire::random({.seed = seed_}, next_++, 77);
  }
  shadow_planes::Vector vector(double low, double high) {
    const double x = (*this)(low, high), y = (*this)(low, high), z = (*this)(low, high);
    return {x, y, z};
  }

 private:
  std::uint64_t seed_;
  std::uint32_t next_ = 0;
};

// How far along `way` from `from` a triangle is hit (Moeller and Trumbore 1997), if it is.
std::optional<long double> ray_meets(const shadow_planes::Vector& from, const shadow_planes::Vector& way,
                                     const shadow_planes::Vector& a, const shadow_planes::Vector& b,
                                     const shadow_planes::Vector& c);

// Whether a convex polygon crosses the open segment, or the ray where light.w is 0.
bool stands_between(const shadow_planes::Convex& part, const shadow_planes::Vector& point,
                    const shadow_planes::Homogeneous& light);

struct FaceMet {
  std::uint32_t face;
  shadow_planes::Vector point;
};

// The nearest face through a point of the image.
std::optional<FaceMet> first_face(const shadow_planes::World& world, const shadow_planes::Camera& camera, Point p);

// What Frame::trace has to see with Clip::both and this light: element and colour.
Hit seen(const shadow_planes::World& world, const shadow_planes::Camera& camera, shadow_planes::Shade shade,
         const shadow_planes::Homogeneous& light, Point p);

}  // namespace moire::test
