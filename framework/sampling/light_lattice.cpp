#include "sampling/light_lattice.h"

#include <numeric>

#include <moire/lattice.h>
#include <moire/random.h>

namespace moire {

namespace {

// A kind of random number that no sampler asks for.
constexpr std::uint32_t of_light = 0x6c696768;

}  // namespace

LightLattice::LightLattice(Pixel pixel, std::uint64_t seed, std::uint32_t count) : count_(count) {
  pixel.frame = 0;
  pixel.seed = seed;
  u_ = random(pixel, 0, of_light);
  v_ = random(pixel, 1, of_light);
  // k -> first + k step modulo the count is a permutation where the step has no factor in common with it.
  first_ = static_cast<std::uint32_t>(random(pixel, 2, of_light) * count);
  step_ = static_cast<std::uint32_t>(random(pixel, 3, of_light) * count);
  while (std::gcd(step_, count) != 1) ++step_;
}

LightPoint LightLattice::point(std::uint32_t k) const {
  return r2_lattice(u_, v_, (first_ + static_cast<std::uint64_t>(k) * step_) % count_);
}

}  // namespace moire
