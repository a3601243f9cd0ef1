// Lines as a brush draws them: long thin polygons with curved sides (Catmull 1978, section "Finding visible surfaces").
#pragma once

#include <string_view>

#include "drawing/pen.h"

namespace cartoon {

// Draws a line along each contour of the path data, `width` wide. Contours that end where they began are as wide
// everywhere; others taper off to points at both ends.
void draw_ink(std::string_view data, double width, Pen& pen);

}  // namespace cartoon
