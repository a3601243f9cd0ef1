// A wedge of directions swept over the ground, row of voxels by row of voxels.
#pragma once

#include <cstdint>

#include <moire/frame.h>

#include "exact/projection.h"
#include "view.h"

namespace heightfield::exact {

// What is asked for of a wedge.
struct Range {
  double start;            // v of the lowest direction of the picture in it: the sweep leaves out what lies below
  double lowest, highest;  // v of the window
  std::span<const moire::Point> part;  // of the picture in the wedge
};

// Streams what is visible of the voxels in the wedge, the same to the bit whatever `lowest` and `highest` are: these
// decide what may be left out. Returns the number of voxels looked at.
std::uint64_t sweep(const View& view, const Plane& axes, const Projection& projection, const Wedge& wedge,
                    const Range& range, moire::PolygonSink& sink);

}  // namespace heightfield::exact
