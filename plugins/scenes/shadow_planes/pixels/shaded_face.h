// What a face sends to the eye.
#pragma once

#include <array>

#include "pixels/seen_face.h"

namespace shadow_planes {

struct ShadedFace {
  SeenFace seen;
  std::array<double, 3> ambient;  // radiance without light
  std::array<double, 3> light;    // radiance for each unit of Sums::light
  double tolerance;               // of Sums::light

  moire::Color color(double of_light) const {
    const auto channel = [&](std::size_t k) { return static_cast<float>(ambient[k] + of_light * light[k]); };
    return {channel(0), channel(1), channel(2)};
  }
};

}  // namespace shadow_planes
