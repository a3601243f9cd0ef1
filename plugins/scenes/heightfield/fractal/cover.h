// What covers one voxel of the fractal terrain.
#pragma once

#include <moire/color.h>

namespace heightfield {

struct Cover {
  moire::Color color;
  double height = 0;  // above the ground, in voxels
};

}  // namespace heightfield
