// The footprint of a window of pixels in plan: which texels of the map it sees, and which of these are sampled.
#pragma once

#include <vector>

#include <moire/element.h>

#include "metrics/picture.h"

namespace moire {

// Blue, red, green as in Cohen-Or 1997, Fig. 9; orange for what is sampled and cannot be seen; white elsewhere.
namespace footprint_colors {
constexpr Color sampled{0.02F, 0.08F, 0.55F}, missed{0.62F, 0.02F, 0.02F}, hidden{0.20F, 0.55F, 0.14F},
    leaked{0.95F, 0.40F, 0.02F}, outside{1, 1, 1};
}

struct FootprintPlan {
  Picture picture;
  std::size_t sampled = 0, missed = 0, leaked = 0;  // texels, of whatever level
  std::size_t hidden = 0;                           // places, each a texel of level 0
};

// `visible` and `seen` are sets of texel elements in rising order: those that can be seen, and those that a method has
// sampled. A place counts as hidden whose middle lies inside the convex hull of the visible texels and which is under
// none of either set. Where texels overlap, visible ones lie over leaked ones and finer ones over coarser. Column i of
// the map lies to the right, row j downward. Error: the footprint spans more than 8192 texels a side.
FootprintPlan footprint_plan(const std::vector<Element>& visible, const std::vector<Element>& seen);

}  // namespace moire
