// What a shape is filled with: SVG's paints and CSS's colours.
#pragma once

#include <string_view>

#include "drawing/drawing.h"

namespace cartoon {

struct Paint {
  enum class Kind {
    none,
    color,
    current,    // the property `color`
    unmodelled  // gradients, patterns, colours that are partly transparent, other notations
  };
  Kind kind = Kind::none;
  Rgb rgb;                // of a colour
  std::string_view text;  // as it was written
};

// Error: not a paint that CSS knows.
Paint parse_paint(std::string_view text);

// "#rrggbb". Error: not of that form.
Rgb parse_hex(std::string_view text);

}  // namespace cartoon
