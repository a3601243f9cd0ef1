// What is visible of ordered polygons in one pixel, in exact arithmetic: what integrators in floating point are held
// to.
#pragma once

#include <span>
#include <vector>

#include "support/polygon_frame.h"

namespace moire::test {

// The visible area in pixel (x, y) of each polygon, which come from front to back, and at last that of the background.
// Nothing is rounded but each number at the end, and before it sums of pieces by less than 2^-150.
std::vector<double> visible_areas(std::span<const FlatPolygon> polygons, int x, int y);

}  // namespace moire::test
