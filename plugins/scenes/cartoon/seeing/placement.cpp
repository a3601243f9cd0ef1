#include "placement.h"

#include <algorithm>

#include <moire/turn.h>

namespace cartoon {

Placement placement_of(const Box& box, const moire::Settings& settings, moire::ImageSize size) {
  const double fit = std::min(size.width / box.width, size.height / box.height);
  const double scale = fit * settings.real("view.zoom");
  // The place of the drawing that is in the image's middle.
  const double x = box.x + box.width / 2 + settings.real("view.x");
  const double y = box.y + box.height / 2 + settings.real("view.y");
  const moire::Turn turning = moire::turn_of(settings.real("view.rotation_deg"));
  const double c = scale * turning.cosine, s = scale * turning.sine;
  return {{c, -s, size.width / 2.0 - (c * x - s * y), s, c, size.height / 2.0 - (s * x + c * y)}, scale};
}

}  // namespace cartoon
