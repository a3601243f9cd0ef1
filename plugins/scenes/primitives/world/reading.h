// Pictures from JSON:
//
//   {"background": "#ffffff",
//    "primitives": [
//      {"type": "line", "from": [-40, 0], "to": [40, 9.5], "width": 2, "cap": "round", "color": "#2060a0",
//       "velocity": [1, 0], "spin_deg": 3},
//      {"type": "circle", "center": [0, 0], "radius": 30, "width": 1}]}
#pragma once

#include <moire/document.h>

#include "primitives.h"

namespace primitives {

// Error: something is missing, unknown, of another type or out of range.
Picture read_picture(const moire::Document& document, const Style& style);

}  // namespace primitives
