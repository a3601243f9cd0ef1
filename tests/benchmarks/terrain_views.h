// The views on which the terrain renderer is timed: Puget Sound with a relief of 30 voxels, at pitch 40, 20 and 5.
#pragma once

#include <memory>

#include "loading/catalog.h"
#include "look.h"
#include "run/contender.h"

namespace moire::benchmark {

struct TerrainView {
  double pitch_deg, height;
};
inline constexpr TerrainView views[] = {{40, 2800}, {20, 1300}, {5, 1000}};

// 400 x 400 pixels, field of view 10 degrees, yaw 20, far limit 30,000, levels floor, one voxel a step.
Settings terrain_settings(const Catalog& catalog, const TerrainView& view);

std::unique_ptr<Contender> contender(const Catalog& catalog, const std::string& type,
                                     const std::vector<std::pair<std::string, Value>>& settings);

// The loops of `point` and of `area` on upright lines over the scene's own walk, compiled in one piece with it.
class OnePiece {
 public:
  OnePiece(const Settings& settings, ImageSize size);
  void point(PixelBlock& block) const;
  void area(PixelBlock& block) const;

 private:
  heightfield::Voxels voxels_;
  heightfield::Look look_;
  Color sky_;
};

}  // namespace moire::benchmark
