// From a picture to the image at one instant.
#pragma once

#include <moire/settings.h>
#include <moire/turn.h>

#include "world/primitives.h"

namespace primitives {

struct View {
  moire::ImageSize size;
  moire::Point center;  // of the picture, in the image's middle
  double zoom = 1;
  moire::Turn turn;
  bool scale_widths = true;

  moire::Point operator()(moire::Point p) const {
    const double x = zoom * (p.x - center.x), y = zoom * (p.y - center.y);
    return {size.width / 2.0 + (turn.cosine * x - turn.sine * y),
            size.height / 2.0 + (turn.sine * x + turn.cosine * y)};
  }
};

View view_of(const moire::Settings& settings, moire::ImageSize size);

// All of them at `time`, in the image, with the elements 1, 2, ...
std::vector<Curve> placed(const std::vector<Primitive>& primitives, double time, const View& view);

}  // namespace primitives
