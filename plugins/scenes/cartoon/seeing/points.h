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

// Makes `hits` those of the points: with[layer], or the last one where no layer is. Returns how many hits
// are layers. What a point gets does not depend
// on the others, but many that follow one another upward at one x are answered together. Requires: one more in `with`
// than there are layers, and as many hits as points.
std::size_t find_hits(const Edges& edges, std::span<const moire::Hit> with, std::span<const moire::SamplePoint> points,
                      std::span<moire::Hit> hits);

}  // namespace cartoon
