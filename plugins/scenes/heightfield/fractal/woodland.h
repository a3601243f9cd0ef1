// Single trees, a few voxels wide.
#pragma once

#include <cstdint>

#include "cover.h"
#include "noise.h"

namespace heightfield {

class Woodland {
 public:
  explicit Woodland(std::uint64_t seed) : sites_(seed, 30) {}

  // `density` 0 .. 1: how many of the sites carry a tree; `conifers` 0 .. 1: how many of those are firs. Where no crown
  // covers the voxel, `open` does.
  Cover at(Vector voxel, double density, double conifers, const Cover& open) const;

 private:
  Noise sites_;
};

}  // namespace heightfield
