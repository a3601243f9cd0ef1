// Pixels of the plane beside what clipping every texel gives.
#pragma once

#include <algorithm>
#include <cmath>

#include "plugins/textured_plane/clipped_texels.h"
#include "textured_plane/frame.h"

namespace moire::test {

// The sky and the far ground as black, so that a sum is of the texels' colours alone.
inline constexpr textured_plane::Surroundings nothing{{0, 0, 0}, {0, 0, 0}};

// The largest difference of a channel's sum.
inline double color_error(const Tally::Sum& sum, const Clipped& exact) {
  return std::max({std::abs(sum.r - exact.r), std::abs(sum.g - exact.g), std::abs(sum.b - exact.b)});
}

// The largest difference of an element's weight.
inline double weight_error(const PixelBlock& block, std::size_t slot, const Clipped& exact) {
  std::map<Element, double> apart = exact.weights;
  block.for_each(slot, [&](const Fragment& f) { apart[f.element] -= f.weight; });
  double worst = 0;
  for (const auto& [element, weight] : apart) worst = std::max(worst, std::abs(weight));
  return worst;
}

}  // namespace moire::test
