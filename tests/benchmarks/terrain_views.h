// The views on which the terrain renderer is timed: Puget Sound with a relief of 30 voxels, at pitch 40, 20 and 5.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <moire/sampler.h>

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
                                     const std::vector<std::pair<std::string, Value>>& settings,
                                     const std::string& lookup = "nearest", const std::string& filter = "box");

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

// `area` on upright lines, each handed to the scene alone: what following them side by side is measured against.
class OneByOne final : public Rendering {
 public:
  OneByOne(const Frame& frame, const Lookup* lookup) : frame_(frame), lookup_(lookup) {}
  void render(PixelBlock& block) const override;

 private:
  const Frame& frame_;
  const Lookup* lookup_;
};

}  // namespace moire::benchmark
