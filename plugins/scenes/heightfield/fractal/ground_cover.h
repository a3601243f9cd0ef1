// What covers the ground of the fractal terrain: water, snow, rock, grass, forest, fields, roads.
#pragma once

#include <cstdint>

#include <moire/color.h>

#include "ground.h"

namespace heightfield {

struct CoveredGround {
  Grid<float> height;         // in voxels, with trees and houses; water is level at 0
  Grid<moire::Color> albedo;  // before light and shadow
};

CoveredGround cover_ground(const Ground& ground, std::uint64_t seed);

}  // namespace heightfield
