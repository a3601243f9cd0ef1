// SVG's attribute `transform`.
#pragma once

#include <string_view>

#include <moire/geometry.h>

namespace cartoon {

// matrix, translate, scale, rotate, skewX and skewY, the last one applied first (SVG 1.1, section 7.6).
// Error: what is wrong; a map that cannot be inverted, as nothing would be left of the drawing.
moire::Affine parse_transform(std::string_view text);

}  // namespace cartoon
