// The exact image of a scene whose polygons do not overlap: each gives every pixel the area it has there, as it comes.
#pragma once

#include <moire/sampler.h>

namespace area {

class Disjoint final : public moire::Rendering {
 public:
  // Requires: the frame has polygons, disjoint ones.
  explicit Disjoint(const moire::Frame& frame) : frame_(frame) {}
  void render(moire::PixelBlock& block) const override;

 private:
  const moire::Frame& frame_;
};

}  // namespace area
