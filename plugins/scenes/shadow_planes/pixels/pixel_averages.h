// Exact averages over pixels under soft and hard shadows.
//
// Irradiance is smooth but for critical lines (critical_lines.h). The image is divided into tiles of 16 x 16 pixels,
// and these into quarters, until a tile shows one face, no critical segment crosses it and a polynomial through a grid
// of points fits well. A pixel that faces share or segments cross is cut along them into convex pieces.
#pragma once

#include <memory>
#include <vector>

#include <moire/frame.h>

#include "pixels/shaded_face.h"
#include "seeing/visible_parts.h"

namespace shadow_planes {

class PixelAverages : public moire::Averages {
 public:
  struct Options {
    double tolerance = 3e-7;  // of a channel, estimated
    bool is_flat = false;     // what is lit has one colour, Light::flat, times the share of the light that it sees
  };

  // `visible` outlives this.
  PixelAverages(const World& world, const Camera& camera, const VisibleParts& visible, Options options);
  PixelAverages(const World& world, const Camera& camera, const VisibleParts& visible)
      : PixelAverages(world, camera, visible, Options{}) {}

  // Elements: the face lit, shadowed by each other face in the order of the world's list, unlit; the sky.
  double integrate(const moire::Filter* filter, moire::PixelBlock& block) const override;

 private:
  const VisibleParts& visible_;
  bool is_flat_;
  moire::Color sky_;
  std::vector<std::unique_ptr<const ShadedFace>> faces_;  // null: not in view
};

}  // namespace shadow_planes
