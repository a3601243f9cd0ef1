// How far a drawing reaches.
#pragma once

#include <optional>

#include "drawing.h"

namespace cartoon {

// The smallest box around all outlines, curves included; none where there are no outlines.
std::optional<Box> bounds_of(const Drawing& drawing);

}  // namespace cartoon
