// The colours of error maps: one definition for the pictures that a run writes and for the scale that a report shows.
//
// Both are straight paths in Oklab (Ottosson 2020, https://bottosson.github.io/posts/oklab), where equal steps look
// alike: the absolute map climbs evenly from black to a warm white, the signed map darkens evenly from white to blue
// below zero and to red above.
#pragma once

#include <string>

#include <moire/color.h>

namespace moire::report {

// Linear light, ready for write_image. Values beyond `scale` get the colour of its end. What is not a number is green,
// which neither map has. Requires: scale > 0.
Color absolute_error_color(double value, double scale);
Color signed_error_color(double value, double scale);

// "#3fa0ff".
std::string css_color(Color color);

}  // namespace moire::report
