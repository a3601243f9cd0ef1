// The part of a texture that a lookup filters over.
#pragma once

#include <algorithm>
#include <limits>
#include <string_view>

#include <moire/texture.h>

namespace moire {

// Of a choice "sample pixel".
inline Footprint footprint_of(std::string_view choice) {
  return choice == "sample" ? Footprint::sample : Footprint::pixel;
}

// Squares of the lengths of a place's two derivatives, texels of level 0. Where one is infinite or not a number both
// are infinite: nobody knows what to filter over.
struct FootprintSides {
  double across, down;  // as the image point goes to its neighbour aside, and below

  explicit FootprintSides(const SurfacePoint& point)
      : across(squared(point.ds_dx) + squared(point.dt_dx)), down(squared(point.ds_dy) + squared(point.dt_dy)) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (!(across + down < infinity)) across = down = infinity;
  }

  double shorter() const { return std::min(across, down); }
  double longer() const { return std::max(across, down); }

 private:
  static double squared(double x) { return x * x; }
};

}  // namespace moire
