// Light and shadow of one sun, baked into the colours of a terrain.
#include "sunlight.h"

#include <algorithm>
#include <cmath>

#include "noise.h"
#include "palette.h"

namespace heightfield {
namespace {

// Towards the sun, in voxels for one voxel in -x: it stands mostly along x, so that copies mirrored in y differ little.
constexpr double aside = -0.45, rise = 0.72;
constexpr moire::Color sun{1.22F, 1.12F, 0.94F}, sky{0.26F, 0.32F, 0.42F};

// Height of the shadow above which a voxel sees the sun. One column after the other, away from the sun.
Grid<float> shadows(const Grid<float>& height) {
  Grid<float> shadow = height;
  for (int x = 1; x < height.width; ++x)
    for (int y = 0; y < height.height; ++y) {
      const double from = y + aside;
      const int y0 = static_cast<int>(std::floor(from));
      const double t = from - y0;
      const double behind = (1 - t) * shadow.near(x - 1, y0) + t * shadow.near(x - 1, y0 + 1);
      shadow.at(x, y) = std::max(height.at(x, y), static_cast<float>(behind - rise));
    }
  return shadow;
}

// Cosine between the sun and the ground's normal, not below 0.
double facing(const Grid<float>& height, int x, int y) {
  const Vector slope = {0.5 * (height.near(x + 1, y) - height.near(x - 1, y)),
                        0.5 * (height.near(x, y + 1) - height.near(x, y - 1))};
  const double normal = std::sqrt(1 + dot(slope, slope)), to_sun = std::sqrt(1 + aside * aside + rise * rise);
  return std::max(0.0, (slope.x - aside * slope.y + rise) / (normal * to_sun));
}

moire::Color lit(moire::Color albedo, double sunlight, double skylight) {
  const moire::Color light = scaled(sun, sunlight) + scaled(sky, skylight);
  const auto channel = [](float reflects, float arrives) { return std::min(reflects * arrives, 1.0F); };
  return {channel(albedo.r, light.r), channel(albedo.g, light.g), channel(albedo.b, light.b)};
}

}  // namespace

void shine(CoveredGround& ground) {
  const Grid<float> shadow = shadows(ground.height);
  for (int y = 0; y < ground.height.height; ++y)
    for (int x = 0; x < ground.height.width; ++x) {
      const double buried = shadow.at(x, y) - ground.height.at(x, y);
      const double sunlight = facing(ground.height, x, y) * ramp(1.5, 0.0, buried);
      ground.albedo.at(x, y) = lit(ground.albedo.at(x, y), 1.25 * sunlight, 1);
    }
}

}  // namespace heightfield
