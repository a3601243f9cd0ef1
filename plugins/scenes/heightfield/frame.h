// A heightfield seen by a camera: rays, image lines and places on the texture, all by one walk over the voxels.
#pragma once

#include <moire/frame.h>

#include "exact/visible_voxels.h"
#include "look.h"

namespace heightfield {

class HeightfieldFrame final : public moire::Frame, private moire::Lines, private moire::Surface {
 public:
  // `exact`: the frame has polygons. Requires: then it has no levels, and the model of rays and weights by area.
  HeightfieldFrame(Look look, moire::Color sky, const moire::Texture& texture, bool exact)
      : look_(std::move(look)), sky_(sky), texture_(texture) {
    if (exact) voxels_.emplace(look_, sky_);
  }

  moire::ImageSize size() const override { return look_.size(); }
  void trace(std::span<const moire::SamplePoint> points, std::span<moire::Hit> hits,
             moire::Counters& counters) const override;
  const moire::Lines* lines() const override { return this; }
  const moire::Polygons* polygons() const override { return voxels_ ? &*voxels_ : nullptr; }
  const moire::Surface* surface() const override { return this; }

 private:
  // Lines.
  void along(std::span<const moire::ImageLine> lines, const moire::Lookup* lookup, moire::Tally& pieces) const override;
  // One line, its stretches the slots from first_slot on.
  void follow(const moire::ImageLine& line, std::size_t first_slot, const moire::Lookup* lookup,
              moire::Tally& pieces) const;
  // The same, a fragment's weight in proportion to the height of what is seen at its own distance (Cohen-Or 1997,
  // fig. 12) instead of its length in the image. A stretch's weights still sum to its length: the sky keeps its own,
  // and what the terrain takes up is divided by height.
  void follow_by_height(const moire::ImageLine& line, std::size_t first_slot, const moire::Lookup* lookup,
                        moire::Tally& pieces) const;
  std::optional<moire::Pole> pole() const override { return look_.camera().nadir(); }

  // Surface.
  void locate(std::span<const moire::SamplePoint> points, std::span<moire::SurfacePoint> out,
              moire::Counters& counters) const override;
  const moire::Texture& texture() const override { return texture_; }

  Look look_;
  moire::Color sky_;
  const moire::Texture& texture_;
  std::optional<VisibleVoxels> voxels_;
};

}  // namespace heightfield
