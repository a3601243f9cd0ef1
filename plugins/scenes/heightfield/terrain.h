// A map of heights and colours, as read or generated.
#pragma once

#include <vector>

#include <moire/color.h>
#include <moire/settings.h>

namespace heightfield {

// Row 0 is the north, column 0 the west; rows follow each other.
struct Terrain {
  int width = 0, height = 0;         // voxels
  std::vector<float> heights;        // of the voxels' tops, in the unit of the data
  std::vector<moire::Color> colors;  // linear light
};

// The terrain that the scene's settings name. Error: unreadable images; heights that are not finite.
Terrain load_terrain(const moire::Settings& settings);

// The mean of `values` (width x height) over each of columns x rows equal parts of the same extent, every value taken
// as constant over its pixel: area-weighted both when the grid gets coarser and when it gets finer.
template <class T>
std::vector<T> resampled(const std::vector<T>& values, int width, int height, int columns, int rows);

}  // namespace heightfield
