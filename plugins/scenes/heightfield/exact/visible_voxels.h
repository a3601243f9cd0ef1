// The exact picture of a terrain of boxes: the visible part of every voxel, as polygons that do not overlap.
#pragma once

#include <moire/frame.h>

#include "look.h"

namespace heightfield {

// What rays that go their own way and meet boxes see (Model{}), no levels: within a wedge of directions, boxes are laid
// before the horizon from near to far. The far limit's circle is followed by chords, so closely that no
// pixel is off by more than 1e-10.
class VisibleVoxels final : public moire::Polygons {
 public:
  // Requires: what is referred to outlives this. The manner of `look` is not looked at.
  VisibleVoxels(const Look& look, moire::Color sky) : look_(look), sky_(sky) {}

  bool disjoint() const override { return true; }
  // Of the window, what lies in the image.
  void stream(const moire::Rectangle& window, moire::PolygonSink& sink) const override;
  moire::Color background_color() const override { return sky_; }

  // As stream(); how many voxels were looked at, each as often as wedges hold a part of it.
  std::uint64_t visit(const moire::Rectangle& window, moire::PolygonSink& sink) const;

 private:
  const Look& look_;
  moire::Color sky_;
};

}  // namespace heightfield
