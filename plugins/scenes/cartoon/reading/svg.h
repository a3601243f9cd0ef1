// Drawings in SVG.
#pragma once

#include <string_view>

#include "drawing/drawing.h"

namespace cartoon {

// What is done about strokes, gradients, transparency and whatever else layers of flat opaque colour cannot show.
enum class Unmodelled { refuse, skip };

// Reads an SVG document (SVG 1.1): paths and basic shapes in groups, with transforms, fills and fill rules; every one
// of them that is filled is a layer. Width and height of the document mean nothing. `name` stands before the line in
// messages. Error: malformed, or with unmodelled parts that are not to be skipped; each of them is listed.
Drawing read_svg(std::string_view text, std::string_view name, Unmodelled unmodelled);

}  // namespace cartoon
