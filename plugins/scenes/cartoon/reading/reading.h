// Drawings from files.
#pragma once

#include <string>
#include <string_view>

#include "svg.h"

namespace cartoon {

// SVG or JSON, as the text begins. `name` stands at the beginning of messages. The result has a view box, that of the
// file or the box around all outlines. Error: unreadable, malformed, or there is nothing to see in it.
Drawing read_drawing(std::string_view text, std::string_view name, Unmodelled unmodelled);

// The same of a file. Error: also, a file that cannot be read or is larger than a gigabyte.
Drawing read_drawing_file(const std::string& file, Unmodelled unmodelled);

}  // namespace cartoon
