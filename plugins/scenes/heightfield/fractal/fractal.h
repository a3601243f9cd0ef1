// A built-in landscape, so that a first picture needs no file: mountains, a lake, forests, fields, villages.
#pragma once

#include <cstdint>

#include "../terrain.h"

namespace heightfield {

// Trees and houses rise at most so far above the relief, in voxels.
inline constexpr double tallest_cover = 4;

// `size` x `size` voxels whose ground lies within 0 .. `relief` voxels; water is level at 0. The same arguments give
// the same bits on every machine. Meant for sizes of 256 to 2048 with a relief of about a tenth of that; any works.
// Light and shadow are in the colours. Requires: size > 0, relief > 0.
Terrain fractal(int size, std::uint64_t seed, double relief);

}  // namespace heightfield
