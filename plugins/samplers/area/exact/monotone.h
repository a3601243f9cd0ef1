// Polygons as Catmull's algorithm takes them: a list of vertices on the left and one on the right, each running
// downward, that do not cross (Catmull 1978, fig. 3).
#pragma once

#include <cstdint>
#include <vector>

#include <moire/geometry.h>

#include "exact/layers.h"

namespace area {

struct MonotonePolygon {
  std::uint32_t layer;
  std::vector<moire::Point> left, right;  // from one y to another, the same on both sides

  double top() const { return left.front().y; }
  double bottom() const { return left.back().y; }
};

// The inside of all layers, each by its fill rule, as such polygons, which do not overlap within a layer. What lies
// above or below the rows [0, rows) is left out.
std::vector<MonotonePolygon> monotone_polygons(const Layers& layers, int rows);

}  // namespace area
