// Few jittered points a pixel, and many where those differ.
#pragma once

#include <moire/reseed.h>
#include <moire/sampler.h>

#include "criterion.h"

namespace adaptive {

// Where the criterion fires in a pixel, or in one of its neighbours in the image, the many replace the few, which would
// keep the bias of having been chosen. Blocks look at the few points of the pixels around them as well.
class TwoLevel final : public moire::Rendering {
 public:
  struct Grids {
    int coarse, fine;  // points along a pixel's side
    bool neighbours;
  };
  TwoLevel(const moire::RenderRequest& request, const Criterion& criterion, Grids grids, moire::Reseed reseed)
      : request_(request), criterion_(criterion), grids_(grids), reseed_(reseed) {}

  void render(moire::PixelBlock& block) const override;

 private:
  // Points of image column x in the pixels of these rows, which go upward: strip by strip of the pixels. `n` along a
  // side; their random numbers begin with that of sample `first`.
  void append(int x, const std::vector<int>& rows, int n, int first, std::vector<moire::SamplePoint>& points,
              std::vector<std::size_t>& ends) const;

  moire::RenderRequest request_;
  Criterion criterion_;
  Grids grids_;
  moire::Reseed reseed_;
};

}  // namespace adaptive
