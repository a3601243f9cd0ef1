// The highest voxels of a level by blocks, so that a walk may pass over voxels that it need not look at.
#pragma once

#include <vector>

namespace heightfield {

struct Cell;

// Blocks of one mirror period of the map: beyond the map's border lies its mirror image. Indices are reduced to one
// period; a period's last blocks may be narrower.
class Summits {
 public:
  static constexpr int block = 16;  // voxels a side

  Summits() = default;
  Summits(const std::vector<Cell>& cells, int width, int height);

  // A run of voxels along one axis (p: rows if `swapped`), and those beside it along the other one.
  struct Run {
    bool swapped;
    int p, q;
    int aside;  // q of the run's last voxel less that of its first, not negative
  };
  // How many voxels a run from p on may have, to end with its block.
  int length(bool swapped, int p) const;
  // No voxel of the run is higher. Requires: p to the run's end lie in one block.
  float highest(const Run& run) const;

 private:
  int width_ = 0, height_ = 0;  // of one period
  int blocks_ = 0;              // in a row
  std::vector<float> highest_;
};

}  // namespace heightfield
