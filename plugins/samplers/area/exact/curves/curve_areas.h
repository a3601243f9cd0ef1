// The exact image of lines and circles: a pixel that one of them covers in part, and all behind it whole or not at all,
// gets its area in closed form; one where several meet is integrated in slabs.
#pragma once

#include <cstdint>
#include <vector>

#include <moire/sampler.h>

#include "exact/curves/shape.h"

namespace area {

class CurveAreas final : public moire::Rendering {
 public:
  // Requires: the frame has curves.
  explicit CurveAreas(const moire::Frame& frame);
  void render(moire::PixelBlock& block) const override;
  moire::Blocks blocks() const override { return moire::Blocks::rows; }

 private:
  class Reader;
  class Tile;

  struct Curve {
    moire::Element element;
    moire::Color color;
    Shape shape;
  };

  void sort_into_tiles();

  moire::ImageSize size_;
  moire::Color background_;
  std::vector<Curve> curves_;  // those in front last
  moire::PixelArea tiles_;     // of the image, in tiles
  // Those of tile t: of touching_ from first_[t] to first_[t + 1].
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> touching_;
};

}  // namespace area
