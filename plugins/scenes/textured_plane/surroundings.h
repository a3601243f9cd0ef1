// What is seen where the texture is not.
#pragma once

#include <moire/color.h>
#include <moire/element.h>

namespace textured_plane {

// The ground beyond the far limit: neither a texel nor the background.
inline constexpr moire::Element far_ground = 1;

struct Surroundings {
  moire::Color sky, far;
};

}  // namespace textured_plane
