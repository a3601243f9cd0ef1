// The voxels of a terrain and their hierarchy, mirrored to infinity.
//
// Voxel (i, j) of level l is the box over [i, i + 1) x [j, j + 1) times 2^l voxels of level 0, with a flat top at the
// mean height of the voxels of level 0 in it and their mean colour. Beyond the border the map is its mirror image.
#pragma once

#include <cstdint>
#include <vector>

#include <moire/element.h>
#include <moire/texture.h>

#include "summits.h"
#include "terrain.h"

namespace heightfield {

struct Cell {
  float height;
  float rgb[3];
};

// How far ahead of itself a walk fetches cells.
inline constexpr int steps_ahead = 12;

class Voxels {
 public:
  // Levels: all whose width divides both sides of the map, so that the levels' mirror images coincide.
  explicit Voxels(const Terrain& terrain);

  struct Level {
    int width, height;
    std::vector<Cell> cells;  // rows follow each other
    // Places in `cells` of wrapped columns and rows: entry k stands for index k, beginning at 0 and going on for two
    // mirror periods or more, so that a walk looks up a neighbour without dividing, and steps_ahead beyond.
    std::vector<std::int32_t> columns, rows;
    Summits summits;
    int column_period() const { return 2 * width; }
    int row_period() const { return 2 * height; }
  };

  int levels() const { return static_cast<int>(levels_.size()); }
  const Level& level(int l) const { return levels_[static_cast<std::size_t>(l)]; }
  float lowest() const { return lowest_; }
  float highest() const { return highest_; }
  double mean_height() const { return mean_height_; }
  bool colors_are_finite() const { return colors_are_finite_; }
  moire::Texture texture() const;

 private:
  std::vector<Level> levels_;
  float lowest_, highest_;
  double mean_height_;
  bool colors_are_finite_;
};

}  // namespace heightfield
