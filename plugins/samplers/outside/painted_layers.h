// Polygons as painters take them.
#pragma once

#include <vector>

#include <moire/frame.h>

namespace outside {

struct PaintedLayer {
  moire::Color color;  // code values
  moire::FillRule rule;
  std::vector<std::vector<moire::Point>> contours;
};

struct Painting {
  moire::ImageSize size;
  moire::Color background;           // code values
  std::vector<PaintedLayer> layers;  // from back to front
};

Painting painting_of(const moire::Frame& frame);

// A frame's colour as code values, and back.
moire::Color codes_of(moire::Color color, moire::Blend blend);
moire::Color of_codes(moire::Color codes, moire::Blend blend);

}  // namespace outside
