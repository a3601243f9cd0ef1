// What a walk over the voxels needs to know of camera and scene settings.
#pragma once

#include <cstdint>
#include <vector>

#include "voxels.h"

namespace heightfield {

// Where walks try to pass over hidden voxels, block by block. The result is the same.
enum class Skip { where_it_pays, everywhere, nowhere };

struct View {
  const Voxels* voxels = nullptr;
  double x = 0, y = 0, z = 0;           // the eye: voxels from the map's corner, and height in the heights' unit
  double spacing_x = 1, spacing_y = 1;  // world units a voxel
  // World units, horizontally from the eye. At the largest, 1e9, the ground is as good as endless: a ray ends where it
  // meets the ground or nothing can rise above it any more, and what lies farther, within height / 1e9 of the horizon,
  // is sky. Without levels a line walks every voxel as far as that where it touches the horizon.
  double far = 0;
  std::vector<double> level_starts = {
      0};  // horizontal distance in world units where each level of the hierarchy begins
  Skip skip = Skip::where_it_pays;

  // A walk that has met none of so many voxels tries to pass over the next ones. It pays where runs of hidden voxels
  // are several blocks long.
  std::int64_t patience() const {
    switch (skip) {
      case Skip::where_it_pays:
        return 32;
      case Skip::everywhere:
        return 0;
      case Skip::nowhere:
        break;
    }
    return std::int64_t{1} << 52;
  }
};

}  // namespace heightfield
