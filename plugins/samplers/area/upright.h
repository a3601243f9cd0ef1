// Area sampling along image columns: `lines` equally spaced lines a pixel, each for a strip of equal width.
#pragma once

#include <moire/sampler.h>

namespace area {

class Upright final : public moire::Rendering {
 public:
  Upright(const moire::RenderRequest& request, int lines) : request_(request), lines_(lines) {}
  void render(moire::PixelBlock& block) const override;

 private:
  moire::RenderRequest request_;
  int lines_;
};

}  // namespace area
