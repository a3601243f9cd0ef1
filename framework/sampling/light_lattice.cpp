#include "sampling/light_lattice.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <moire/random.h>

namespace moire {

namespace {

// Rounding to float may reach 1.
float below_one(double x) { return std::min(static_cast<float>(x - std::floor(x)), 0x1.fffffep-1F); }

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
  constexpr double g = 1.32471795724474602596;
  const auto index = static_cast<double>((first_ + static_cast<std::uint64_t>(k) * step_) % count_);
  return {below_one(u_ + index / g), below_one(v_ + index / (g * g))};
}

}  // namespace moire
