// Random numbers that depend on what they are for and on nothing else, so that no order or thread can change them.
#pragma once

#include <cstdint>

namespace moire {

// The pixel a sampler works on. `seed` and `frame` choose its random numbers; a method whose pattern shall stand
// still in an animation keys on frame 0.
struct Pixel {
  int x = 0, y = 0;
  int frame = 0;
  std::uint64_t seed = 0;
};

// The finaliser of SplitMix64 (Steele, Lea, Flood 2014, doi:10.1145/2660193.2660195): a bijection that mixes well.
constexpr std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31);
}

// A uniform number in [0, 1), one for each (seed, frame, pixel, sample, dimension).
constexpr double random(const Pixel& pixel, std::uint32_t sample, std::uint32_t dimension) {
  constexpr std::uint64_t step = 0x9e3779b97f4a7c15U;  // 2^64 / golden ratio, SplitMix64's increment
  const auto place =
      static_cast<std::uint64_t>(static_cast<std::uint32_t>(pixel.x)) << 32 | static_cast<std::uint32_t>(pixel.y);
  const auto use = static_cast<std::uint64_t>(sample) << 32 | dimension;
  std::uint64_t z = mixed(pixel.seed + step);
  z = mixed(z + step * (static_cast<std::uint64_t>(static_cast<std::uint32_t>(pixel.frame)) + 1));
  z = mixed(z + step * (place + 1));
  z = mixed(z + step * (use + 1));
  return static_cast<double>(z >> 11) * 0x1p-53;
}

}  // namespace moire
