// The basic shapes of SVG.
#pragma once

#include <pugixml.hpp>

#include "drawing/pen.h"

namespace cartoon {

// Draws path, rect, circle, ellipse, polygon or polyline. False: the element is none of them.
// Error: what is wrong, after the attribute's name.
bool draw_shape(std::string_view name, const pugi::xml_node& element, Pen& pen);

}  // namespace cartoon
