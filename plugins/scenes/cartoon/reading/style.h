// The properties of SVG that say whether and how a shape is painted.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <pugixml.hpp>

#include "paint.h"

namespace cartoon {

// Goes on to the elements within.
struct Style {
  Paint fill{Paint::Kind::color, {}, "black"};
  double fill_opacity = 1;
  moire::FillRule rule = moire::FillRule::nonzero;
  Paint stroke;
  bool stroke_has_width = true;
  double stroke_opacity = 1;
  bool visible = true;
  Rgb color;  // what currentColor stands for
};

// Of one element.
struct OwnStyle {
  bool shown = true;                    // false: neither it nor what is within
  std::vector<std::string> unmodelled;  // what is asked of it as a whole, and within
};

// Changes `style`, which is the parent's, to the element's: by its attributes, then by its attribute `style`.
// Error: what is wrong, after the property's name.
OwnStyle read_style(const pugi::xml_node& element, Style& style);

}  // namespace cartoon
