// Averages of pixels to a stated bound, for views of any yaw and roll.
#pragma once

#include <moire/tally.h>

#include "surroundings.h"
#include "texels.h"
#include "view.h"

namespace textured_plane {

// A pixel's part of the picture is cut along the texture's blocks. A block may stand with its mean colour if the error
// of that is bounded by `tolerance` times its area in the pixel, or by a thousandth of `tolerance`; else it is cut into
// four, down to texels, where there is no error. The sum of all bounds is the pixel's. A pixel with few texels takes
// all of them.
class Quadtree {
 public:
  // Requires: both outlive this.
  Quadtree(const View& view, const Texels& texels, const Surroundings& surroundings, double tolerance);

  // As moire::Averages::integrate. Recorded texels are found one by one: that is dear close to the horizon, where a
  // pixel sees very many.
  double integrate(moire::PixelBlock& block) const;

 private:
  const View& view_;
  const Texels& texels_;
  Surroundings surroundings_;
  double tolerance_;
  const Blocks& blocks_;
};

}  // namespace textured_plane
