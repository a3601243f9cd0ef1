// The irradiance of an area light, in long double and by another way than the scene's: casters are projected from the
// point onto the light's plane, the light is cut into trapezoids between all their corners and crossings, and the
// kernel integrated over what no caster covers by Gauss's rule of 20 x 20 points a trapezoid.
#pragma once

#include <cstddef>

#include "world/world.h"

namespace shadow_planes::test {

struct LightTruth {
  double irradiance = 0, lit = 0;
};

// Requires: x before the light and off the planes of casters, by more than 1e-4 of its distance from the light's plane;
// casters between the receiver and that plane; the light on the side of the receiver that `normal` points to.
LightTruth light_truth(const World& world, std::size_t receiver, Vector x, Vector normal);

}  // namespace shadow_planes::test
