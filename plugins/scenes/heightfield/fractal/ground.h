// The bare ground of the fractal terrain: a river with a lake, mountains on one side, plains and hills on the other.
#pragma once

#include <cstdint>

#include "grid.h"

namespace heightfield {

struct Ground {
  double relief;        // what the heights are meant to reach at most
  Grid<double> height;  // in voxels; below 0 where water stands, by its depth
  Grid<float> stream;   // 0 .. 1: how much of the voxel is a stream
};

Ground raise_ground(int size, std::uint64_t seed, double relief);

}  // namespace heightfield
