// What is visible of curves in one pixel, in extended precision and without a thought for where they cross: what exact
// areas are held to.
#pragma once

#include <span>
#include <vector>

#include "support/curve_frame.h"

namespace moire::test {

// The visible area in pixel (x, y) of each curve, which come from back to front, and at last that of the background.
// Visible lengths along rows of no height, integrated over y: an interval is halved until Lobatto's rule of five points
// and its halves agree within 1e-16 twice in turn, or the interval is 2^-50 high. It begins with eighths of the pixel,
// the heights at which shapes begin and end, and those at which circles come nearest to something.
std::vector<double> visible_areas(std::span<const Curve> curves, int x, int y);

}  // namespace moire::test
