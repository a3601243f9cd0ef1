// Lines that end nowhere near the image, cut to numbers that can be counted with.
#pragma once

#include <optional>

#include "../pixels.h"

namespace scan_conversion {

struct Ends {
  moire::Point from, to;
};

// The part within `farthest` of the origin, to the last places of doubles; lines that end there stay as they are.
// Nothing: none of it is.
std::optional<Ends> within_reach(moire::Point from, moire::Point to);

}  // namespace scan_conversion
