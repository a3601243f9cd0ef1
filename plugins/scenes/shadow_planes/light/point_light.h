// A light without area, near or infinitely far: it is hidden or not.
#pragma once

#include "light/illumination.h"

namespace shadow_planes {

class PointLight : public Illumination {
 public:
  PointLight(const World& world, std::uint32_t receiver, const Plane& side)
      : Illumination(world, receiver, side),
        place_(world.light.place),
        is_point_(world.light.kind == LightKind::point) {}

  Reach at(Vector x, std::span<const std::uint32_t> candidates, Scratch& scratch) const override;
  void narrow(std::span<const Vector> hull, std::span<const std::uint32_t> candidates,
              std::vector<std::uint32_t>& out) const override;

 private:
  Vector place_;
  bool is_point_;
};

}  // namespace shadow_planes
