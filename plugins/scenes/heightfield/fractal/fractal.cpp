// A built-in landscape.
#include "fractal.h"

#include <utility>

#include "ground_cover.h"
#include "sunlight.h"

namespace heightfield {

Terrain fractal(int size, std::uint64_t seed, double relief) {
  CoveredGround ground = cover_ground(raise_ground(size, seed, relief), seed);
  shine(ground);
  return {size, size, std::move(ground.height.values), std::move(ground.albedo.values)};
}

}  // namespace heightfield
