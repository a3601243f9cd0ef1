#include "light/illumination.h"

#include <numeric>

#include "light/area_light.h"
#include "light/point_light.h"

namespace shadow_planes {

Illumination::Illumination(const World& world, std::uint32_t receiver, const Plane& side)
    : side_(side), casters_(casters_on(world, receiver, side)), all_(casters_.size()) {
  std::iota(all_.begin(), all_.end(), 0U);
}

std::unique_ptr<const Illumination> illumination_of(const World& world, std::uint32_t receiver, const Plane& side) {
  if (world.light.kind == LightKind::area) return std::make_unique<AreaLight>(world, receiver, side);
  return std::make_unique<PointLight>(world, receiver, side);
}

}  // namespace shadow_planes
