// A drawing: layers of flat opaque colour with curved outlines, back to front, in its own coordinates.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <moire/frame.h>

namespace cartoon {

// sRGB code values, as files store them.
struct Rgb {
  std::uint8_t r = 0, g = 0, b = 0;
  friend bool operator==(const Rgb&, const Rgb&) = default;
};

// The parts of an outline, and what each takes from the list of points beyond where the last one ended.
enum class Verb : std::uint8_t {
  move,       // begins a contour there; contours are closed implicitly
  line,       // the end
  quadratic,  // a control point, the end
  cubic,      // two control points, the end
  arc,        // centre c, vectors u and v, (a, b), the end: c + u cos t + v sin t for t from a to b, in radians
};
constexpr std::size_t points_of(Verb verb) {
  constexpr std::size_t counts[] = {1, 1, 2, 3, 5};
  return counts[static_cast<std::size_t>(verb)];
}

// Verbs first_verb .. and points first_point .. of the drawing, up to those of the next layer.
struct Layer {
  std::size_t first_verb = 0, first_point = 0;
  Rgb color;
  moire::FillRule rule = moire::FillRule::nonzero;
};

// A box with its upper left corner.
struct Box {
  double x = 0, y = 0, width = 0, height = 0;
  friend bool operator==(const Box&, const Box&) = default;
};

// No coordinate of a drawing is larger than this, so that products of three of them stay finite.
inline constexpr double largest_coordinate = 1e9;

struct Drawing {
  std::vector<Layer> layers;
  std::vector<Verb> verbs;
  std::vector<moire::Point> points;
  std::optional<Box> view_box;    // what the image is to show; none: all that is drawn
  std::optional<Rgb> background;  // where nothing is drawn

  std::size_t verb_end(std::size_t layer) const {
    return layer + 1 < layers.size() ? layers[layer + 1].first_verb : verbs.size();
  }
};

}  // namespace cartoon
