// Drawings in JSON.
#pragma once

#include <string_view>

#include "drawing/drawing.h"

namespace cartoon {

// Reads {"layers": [{"color": "#rrggbb", "rule": "nonzero", "contours": [[[x, y], ...], ...]}, ...]}, back to front;
// "rule" may be "evenodd", and is nonzero where there is none. Beside the layers there may be "background": "#rrggbb"
// and "view_box": [x, y, width, height]. Contours are closed. `name` stands before the line in messages.
// Error: anything else.
Drawing read_json(std::string_view text, std::string_view name);

}  // namespace cartoon
