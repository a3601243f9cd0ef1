// What people draw flat polygons with today: renderers that paint layer over layer into 8-bit pixels, blending numbers
// as stored, and so are wrong where edges of layers share a pixel.
#pragma once

#include <string>

#include <moire/color.h>

namespace outside {

class Canvas {
 public:
  virtual ~Canvas() = default;
  virtual std::string name() const = 0;
  // Clears and paints all layers, from paths made beforehand.
  virtual void draw() = 0;
  // The code values of a pixel, 0 .. 1.
  virtual moire::Color codes(int x, int y) const = 0;
};

}  // namespace outside
