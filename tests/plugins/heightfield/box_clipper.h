// The exact content of a pixel of a small terrain, by another way than the scene's: boxes are cut out of the pixel one
// after another, from near to far.
#pragma once

#include <map>

#include "plugins/heightfield/small_terrain.h"

namespace moire::test {

// The area that each element takes up of pixel (x, y); what is left is sky. Requires: the eye is above all boxes and
// the far limit beyond all that the pixel shows.
std::map<Element, double> box_areas(const Map& map, const View& view, int x, int y);

}  // namespace moire::test
