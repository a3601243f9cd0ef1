// Points of an area light for the points of one pixel that give none of their own.
#pragma once

#include <cstdint>
#include <optional>

#include <moire/sampler.h>

namespace moire {

// What chooses the points of the light; nothing: the light is no area.
using LightSeed = std::optional<std::uint64_t>;

// 0 for samplers without random numbers: their points of the light are the same in every run.
inline LightSeed light_seed_of(const RenderRequest& request, bool is_deterministic) {
  if (!request.frame.receivers()) return {};
  return is_deterministic ? 0 : request.seed;
}

// The first `count` points of the R2 lattice, moved at random from pixel to pixel, in a random order, so that a pixel's
// upper points do not see one side of the light. It stands still in an animation.
class LightLattice {
 public:
  LightLattice(Pixel pixel, std::uint64_t seed, std::uint32_t count);
  // Requires: k < count.
  LightPoint point(std::uint32_t k) const;

 private:
  double u_, v_;
  std::uint32_t count_, first_, step_;
};

}  // namespace moire
