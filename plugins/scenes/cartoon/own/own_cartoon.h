// The cartoon that needs no file: a cat before a picket fence, a cottage, hills and the sun.
#pragma once

#include "drawing/drawing.h"

namespace cartoon {

Drawing own_cartoon();

}  // namespace cartoon
