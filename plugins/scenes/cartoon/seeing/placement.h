// Where a drawing lies in the image.
#pragma once

#include <moire/geometry.h>
#include <moire/settings.h>

#include "drawing/drawing.h"

namespace cartoon {

struct Placement {
  moire::Affine map;  // from the drawing to the image
  double scale = 1;   // pixels for a unit of the drawing
};

// The box fitted into the image, its proportions kept and in the middle; then moved, enlarged about the image's middle
// and turned as the settings under "view." say.
Placement placement_of(const Box& view_box, const moire::Settings& settings, moire::ImageSize size);

}  // namespace cartoon
