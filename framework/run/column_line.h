// The exact content of the upright line through the middles of an image column's pixels.
#pragma once

#include <moire/sampler.h>

namespace moire {

// Requires: the frame answers lines.
class ColumnLine final : public Rendering {
 public:
  explicit ColumnLine(const Frame& frame) : frame_(frame) {}
  void render(PixelBlock& block) const override;

 private:
  const Frame& frame_;
};

}  // namespace moire
