// What a picture consists of: lines and circles, those in front last.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include <moire/curves.h>

namespace primitives {

using Curve = std::variant<moire::LineCurve, moire::CircleCurve>;

// Per unit of time. Turns are about the curve's own middle, clockwise.
struct Motion {
  moire::Point velocity;
  double spin_deg = 0;
};

// As it is at time 0, in pixels of an image that shows it unenlarged; (0, 0) is the image's middle. Its element is
// given when it is placed.
struct Primitive {
  Curve curve;
  Motion motion;
};

struct Picture {
  std::vector<Primitive> primitives;
  std::optional<moire::Color> background;
};

// What primitives have that say nothing else.
struct Style {
  moire::Color color;
  double width = 1;
  moire::Cap cap = moire::Cap::butt;
};

// Of all coordinates and lengths, in pixels.
inline constexpr double largest_length = 1e7;

}  // namespace primitives
