#pragma once

#include "support/hard_pixels/sketch.h"

namespace moire::test::hard {

// A thousand layers in one pixel: side by side, one in another, strewn about, around a corner, or all the same.
void thousand_layers(Sketch& sketch);

}  // namespace moire::test::hard
