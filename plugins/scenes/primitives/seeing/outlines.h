// Shapes as polygons.
#pragma once

#include <cstdint>
#include <vector>

#include <moire/geometry.h>

#include "shapes.h"

namespace primitives {

struct Outline {
  std::vector<moire::Point> points;
  std::vector<std::uint32_t> contours;  // of the fill rule even_odd
};

// A rectangle is exact. Circles become regular polygons of the same area, round ends chords of the same area, no
// farther from their curve than `tolerance` pixels within `window`. Beyond it chords may be long: what they leave out
// or add lies outside.
void outline_of(const Shape& shape, const moire::Rectangle& window, double tolerance, Outline& out);

}  // namespace primitives
