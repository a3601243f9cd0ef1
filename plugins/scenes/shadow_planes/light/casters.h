// What can come between a receiver and the light.
#pragma once

#include <cstdint>
#include <vector>

#include "world/world.h"

namespace shadow_planes {

// The part of a convex polygon on the positive side of a plane. What lies in the plane, but for 1e-12 of the size of
// its coordinates, counts as on that side. Nothing where less than a triangle remains.
Convex clipped(const Convex& polygon, const Plane& plane);

// A convex part of a face, cut to where it can cast a shadow.
struct Caster {
  std::uint32_t face;
  Plane plane;
  Convex corners;
};

// All that may hide the light from points of face `receiver`, in the order of the world's faces. `side`: the receiver's
// plane, its normal to the side that is lit. Parts behind it or beyond the light are cut away; parts in it, or
// beside the box around receiver and light, are left out.
std::vector<Caster> casters_on(const World& world, std::uint32_t receiver, const Plane& side);

}  // namespace shadow_planes
