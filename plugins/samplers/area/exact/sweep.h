// The exact picture of ordered polygons by a scanline sweep over rows.
#pragma once

#include <moire/sampler.h>

#include "exact/chains.h"
#include "exact/layers.h"

namespace area {

class Sweep final : public moire::Rendering {
 public:
  explicit Sweep(const moire::RenderRequest& request);
  void render(moire::PixelBlock& block) const override;
  moire::Blocks blocks() const override { return moire::Blocks::rows; }

 private:
  moire::ImageSize size_;
  Layers layers_;
  Chains chains_;
};

}  // namespace area
