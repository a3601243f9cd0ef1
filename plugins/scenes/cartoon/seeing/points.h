// Which layer is on top at points of the image.
//
// A point lies within a contour as often as the contour turns around it: the sum of the turns of those edges that a
// line from the point straight down (towards greater y) meets. An edge is met where x0 <= x < x1 and its y is greater
// than the point's. So a point on an edge belongs to the lower side, or right of upright ones, and with edges that two
// layers share to exactly one of them.
#pragma once

#include <span>

#include <moire/frame.h>

#include "edges.h"

namespace cartoon {

// Writes the layer of each point, or Stack::empty. What a point gets does not depend on the others, but many that
// follow one another upward in one column are answered together. `layers`: how many there are.
void find_layers(const Edges& edges, std::size_t layers, std::span<const moire::SamplePoint> points,
                 std::span<std::uint32_t> found);

}  // namespace cartoon
