// A heightfield seen by a camera: rays, image lines and places on the texture, all by one walk over the voxels.
#pragma once

#include <moire/frame.h>

#include "camera.h"
#include "view.h"
#include "walk.h"

namespace heightfield {

// How a frame walks.
struct Manner {
  bool grid = true;    // every voxel under a ray, or one a step along its major axis
  bool resume = true;  // rays above one another go on where the last one ended
  int retrace = 0;     // voxels to go back before they do
};

class HeightfieldFrame final : public moire::Frame, private moire::Lines, private moire::Surface {
 public:
  HeightfieldFrame(moire::ImageSize size, View view, Camera camera, Manner manner, moire::Color sky,
                   const moire::Texture& texture)
      : size_(size), view_(std::move(view)), camera_(camera), manner_(manner), sky_(sky), texture_(texture) {}

  moire::ImageSize size() const override { return size_; }
  void trace(std::span<const moire::SamplePoint> points, std::span<moire::Hit> hits,
             moire::Counters& counters) const override;
  const moire::Lines* lines() const override { return this; }
  const moire::Surface* surface() const override { return this; }

 private:
  // Lines. What a stretch sees is exact in the vertical plane through its middle: along lines through the nadir point
  // that is the plane of the line itself. Requires: the line is upright or passes through the pole.
  void along(moire::Point from, moire::Point to, std::span<const double> cuts, const moire::Lookup* lookup,
             moire::Tally& pieces) const override;
  std::optional<moire::Pole> pole() const override { return camera_.nadir(); }

  // Surface.
  void locate(std::span<const moire::SamplePoint> points, std::span<moire::SurfacePoint> out,
              moire::Counters& counters) const override;
  const moire::Texture& texture() const override { return texture_; }

  template <bool grid, class Met, class Missed>
  void rays(std::span<const moire::SamplePoint> points, moire::Counters& counters, Met met, Missed missed) const;
  template <bool grid, class Add>
  void stretches(moire::Point from, moire::Point to, std::span<const double> cuts, moire::Counters& counters,
                 Add add) const;
  template <bool grid>
  moire::SurfacePoint surface_point(const Walk<grid>& walk, const Voxel& voxel, double x, Direction d) const;

  moire::ImageSize size_;
  View view_;
  Camera camera_;
  Manner manner_;
  moire::Color sky_;
  const moire::Texture& texture_;
};

}  // namespace heightfield
