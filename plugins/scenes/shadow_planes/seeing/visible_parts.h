// Which faces a window of the image shows, and where in it.
#pragma once

#include <vector>

#include <moire/geometry.h>

#include "seeing/image_parts.h"

namespace shadow_planes {

class VisibleParts {
 public:
  VisibleParts(const Bsp& bsp, const Camera& camera);
  VisibleParts(const World& world, const Camera& camera) : VisibleParts(Bsp(world), camera) {}

  // Replaces `out` by convex parts that are disjoint and together the window; those below 1e-14 of its area, which
  // only rounding makes, are left out. Safe from many threads.
  // Requires: the window is not empty, and no farther from the image than this is wide and high, or 64 pixels.
  void in(const moire::Rectangle& window, std::vector<Part>& out) const;

 private:
  struct Boxed {
    Part part;
    moire::Rectangle box;
  };
  std::vector<Boxed> parts_;  // front to back
};

}  // namespace shadow_planes
