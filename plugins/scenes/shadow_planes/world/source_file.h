// Worlds from JSON files.
#pragma once

#include <moire/document.h>

#include "world/source.h"

namespace shadow_planes {

// {"light": {"points": [[x, y, z], ...], "at": [x, y, z], "towards": [x, y, z], "color": "#ffffff"},
//  "faces": [{"points": [[x, y, z], ...], "reflectance": "#808080", "casts": true, "receives": true}, ...]}
// The light needs what its kind asks for; all else but a face's points may be left out. Coordinates: -1e6 to 1e6 units.
// Error: something is missing, unknown or out of range, a polygon is not flat, crosses itself or has more than 1,000
// corners.
Source read_source(const moire::Document& document);

}  // namespace shadow_planes
