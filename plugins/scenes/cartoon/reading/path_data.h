// The outlines of SVG's attribute `d`.
#pragma once

#include <string_view>

#include "drawing/pen.h"

namespace cartoon {

// Draws path data (SVG 1.1, section 8.3): all commands, relative and absolute, implicitly repeated.
// Error: what is wrong, after the character where it is.
void draw_path_data(std::string_view data, Pen& pen);

}  // namespace cartoon
