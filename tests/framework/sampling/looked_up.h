// Textures of noise, and what lookups make of places on them.
#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <moire/random.h>
#include <moire/texture.h>

#include "sampling/lookups.h"

namespace moire::test {

// Numbers in 0 .. 1 without a pattern.
inline std::vector<float> noise_texels(int width, int height) {
  std::vector<float> rgb;
  for (int k = 0; k < 3 * width * height; ++k) rgb.push_back(static_cast<float>(random({.x = k}, 0, 0)));
  return rgb;
}

struct NoiseTexture {
  int width, height;
  std::vector<float> rgb = noise_texels(width, height);
  Texture texture;

  NoiseTexture(int own_width, int own_height, Wrap wrap)
      : width(own_width), height(own_height), texture({{rgb.data(), 3, width, height}}, wrap) {}
  NoiseTexture(const NoiseTexture&) = delete;
  NoiseTexture& operator=(const NoiseTexture&) = delete;
};

using LookupChanges = std::vector<std::pair<std::string, Value>>;

// Names are without their group: {"bias", -1.0}.
inline std::unique_ptr<Lookup> lookup(std::string_view name, const LookupChanges& changes = {}) {
  for (const NamedSummary& known : lookups()) {
    if (known.name != name) continue;
    Settings settings(known.parameters);
    for (const auto& [key, value] : changes) settings.set(std::string(name) + "." + key, value);
    return make_lookup(name, settings);
  }
  return nullptr;
}

// A place and its derivatives.
inline SurfacePoint place(double s, double t, float ds_dx = 0, float dt_dx = 0, float ds_dy = 0, float dt_dy = 0) {
  SurfacePoint point;
  point.textured = true;
  point.s = s;
  point.t = t;
  point.ds_dx = ds_dx;
  point.dt_dx = dt_dx;
  point.ds_dy = ds_dy;
  point.dt_dy = dt_dy;
  return point;
}

struct LookedUp {
  Tally::Sum sum;
  std::vector<Fragment> fragments;

  Color color() const {
    return {static_cast<float>(sum.r / sum.weight), static_cast<float>(sum.g / sum.weight),
            static_cast<float>(sum.b / sum.weight)};
  }
};

inline LookedUp looked_up(const Lookup& lookup, const SurfacePoint& point, const Texture& texture,
                          bool recording = true, double weight = 1) {
  Tally tally(1, recording);
  lookup.deposit(point, texture, weight, tally, 0);
  LookedUp result{tally.sum(0), {}};
  tally.for_each(0, [&](const Fragment& f) { result.fragments.push_back(f); });
  return result;
}

// One of many places without a pattern, far and near, with footprints from much smaller than a texel to much larger
// than the texture.
inline SurfacePoint some_place(int number, double reach) {
  const auto uniform = [&](std::uint32_t use) { return random({.x = number}, 1, use); };
  const auto way = [&](std::uint32_t use) {
    return static_cast<float>((uniform(use) < 0.5 ? -1 : 1) * std::exp2(uniform(use + 1) * 14 - 6));
  };
  return place((uniform(0) - 0.5) * reach, (uniform(1) - 0.5) * reach, way(2), way(4), way(6), way(8));
}

}  // namespace moire::test
