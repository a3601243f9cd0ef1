// Whitted's recursion: a cell whose corners differ is cut into four, and corners are shared.
#pragma once

#include <moire/sampler.h>

#include "criterion.h"

namespace adaptive {

// The first lattice has 2^first cells along a pixel's side, the finest 2^depth if that is more. A cell that is not cut
// counts by its area, a quarter for each corner: where all are cut that is the trapezoid rule over the finest lattice.
// The corner of a large cell in the middle of a small one's side is not heeded by the large one, which has seen no
// difference there.
//
// Each level is looked at at once, column by column of its lattice. Blocks look at all corners of their own pixels:
// those on their right and lower borders belong to the next pixels too and are looked at again there.
class Corners final : public moire::Rendering {
 public:
  struct Lattices {
    int first, depth;
  };
  Corners(const moire::RenderRequest& request, const Criterion& criterion, Lattices lattices)
      : request_(request), criterion_(criterion), lattices_(lattices) {}

  void render(moire::PixelBlock& block) const override;

 private:
  moire::RenderRequest request_;
  Criterion criterion_;
  Lattices lattices_;
};

}  // namespace adaptive
