// The hidden-surface algorithm of Catmull 1978, as published: polygons sorted in y; those that a scanline meets are
// clipped to it and broken into solid runs and irregular pieces; these are sorted into an x-bucket and, pixel by pixel,
// into a z-list; what a pixel shows comes from the z-list, by the pixel integrator where pieces are irregular.
//
// Published for polygons that come as lists of left and right vertices: monotone.h makes them of what has any contours
// and fill rule.
#pragma once

#include <moire/sampler.h>

#include "exact/layers.h"
#include "exact/monotone.h"
#include "exact/row_buckets.h"

namespace area {

class Catmull final : public moire::Rendering {
 public:
  // jagged: without the integrator, the foremost piece at the pixel's middle.
  Catmull(const moire::RenderRequest& request, bool jagged);
  void render(moire::PixelBlock& block) const override;
  moire::Blocks blocks() const override { return moire::Blocks::rows; }

 private:
  moire::ImageSize size_;
  bool jagged_;
  Layers layers_;
  std::vector<MonotonePolygon> polygons_;
  RowBuckets buckets_;
};

}  // namespace area
