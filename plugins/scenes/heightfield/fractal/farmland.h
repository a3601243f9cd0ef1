// Fields, hedges, farm tracks and villages of the plains: a patchwork that is full of stripes.
#pragma once

#include <cstdint>

#include "cover.h"
#include "noise.h"

namespace heightfield {

// A plot of land: the places nearest to one of many scattered sites.
struct Plot {
  std::uint64_t hash;
  Vector site, from_site;  // voxels
  double border;           // distance to the next plot, voxels; not told beyond `farthest_border`
};

class Farmland {
 public:
  explicit Farmland(std::uint64_t seed) : plots_(seed, 20), bend_(seed, 21), grain_(seed, 22) {}

  Plot plot(Vector voxel) const;
  Cover at(Vector voxel, const Plot& plot) const;

 private:
  Cover hedge(Vector voxel, double into) const;

  Noise plots_, bend_, grain_;
};

}  // namespace heightfield
