// Single trees, a few voxels wide.
#include "woodland.h"

#include <cmath>

#include "palette.h"

namespace heightfield {
namespace {

constexpr double spacing = 2.9;  // voxels between sites, on average

// Firs are cones, broad-leaved trees domes.
Cover crown(std::uint64_t hash, bool fir, double from_trunk) {
  const double size = part(hash, 32), radius = (fir ? 1.2 : 1.5) + 0.9 * size;
  const double t = from_trunk / radius;
  if (t >= 1) return {};
  const double height = (fir ? 3.6 * (1 - 0.8 * t) : 2.8 * std::sqrt(1 - 0.9 * t * t)) * (0.55 + 0.45 * size);
  const double tint = part(hash, 44);
  moire::Color leaves = fir ? palette::fir : mix(palette::beech, palette::fir, 0.6 * tint);
  if (!fir && tint > 0.93) leaves = palette::autumn;
  return {scaled(leaves, 0.7 + 0.8 * part(hash, 20) - 0.3 * t), height};
}

}  // namespace

Cover Woodland::at(Vector voxel, double density, double conifers, const Cover& open) const {
  const Vector p = (1 / spacing) * voxel;
  const auto ix = static_cast<int>(std::floor(p.x)), iy = static_cast<int>(std::floor(p.y));
  Cover highest = open;
  for (int j = iy - 1; j <= iy + 1; ++j)
    for (int i = ix - 1; i <= ix + 1; ++i) {
      const std::uint64_t hash = hashed(sites_.key(), i, j);
      if (part(hash, 0) >= density) continue;
      const Vector site = {i + 0.15 + 0.7 * part(hash, 8), j + 0.15 + 0.7 * part(hash, 24)};
      const Cover tree = crown(hash, part(hash, 48) < conifers, spacing * length(site - p));
      if (tree.height > highest.height) highest = tree;
    }
  return highest;
}

}  // namespace heightfield
