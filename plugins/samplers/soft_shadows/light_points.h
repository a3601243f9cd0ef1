// Sets of points that stand for an area light.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include <moire/geometry.h>
#include <moire/random.h>

namespace soft_shadows {

enum class Pattern {
  lattice,   // Fibonacci: the k-th of N at ((k + 1/2) / N, k times the golden ratio)
  grid,      // the middles of n x n cells
  jittered,  // one anywhere in each of n x n cells
  random,    // anywhere
  rotated,   // the R2 lattice (Roberts 2018), moved at random
};

// Which of them draw random numbers.
constexpr bool is_random(Pattern pattern) { return pattern != Pattern::lattice && pattern != Pattern::grid; }

// As a parameter has them, in the order of Pattern.
inline constexpr std::string_view patterns = "lattice grid jittered random rotated";
// Requires: one of them.
Pattern pattern_of(std::string_view name);

// n x n points. `key` chooses the random numbers. Requires: n >= 1.
std::vector<moire::LightPoint> light_points(Pattern pattern, std::uint32_t n, const moire::Pixel& key);

}  // namespace soft_shadows
