// Area sampling along lines through the scene's pole, where heightfields are exact. Every line stands for a wedge, and
// gives each pixel exactly the area in which wedge and pixel overlap: a pixel's weights sum to 1, whatever the view.
#pragma once

#include <vector>

#include <moire/sampler.h>

#include "fan.h"

namespace area {

class Radial final : public moire::Rendering {
 public:
  // Requires: the frame has lines with a pole.
  Radial(const moire::RenderRequest& request, int lines);
  void render(moire::PixelBlock& block) const override;

 private:
  moire::RenderRequest request_;
  std::vector<Fan> fans_;
};

}  // namespace area
