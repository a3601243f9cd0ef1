// Fragments of faces as outlines of the image, front to back.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "seeing/bsp.h"
#include "seeing/camera.h"
#include "seeing/outline.h"

namespace shadow_planes {

// A convex part of the image that shows one face, or shows it where nothing nearer does.
struct Part {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t face = none;  // none: the sky
  Outline outline;
};

// All that is in view, and around it as far again as the image is wide and high, and 64 pixels: no part hides one
// before it.
std::vector<Part> image_parts(const Bsp& bsp, const Camera& camera);

}  // namespace shadow_planes
