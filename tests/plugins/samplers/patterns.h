// The points that a plugin's pattern gives one pixel.
#pragma once

#include <memory>

#include "support/plugins.h"

namespace moire::test {

inline std::unique_ptr<PointSampler> pattern(std::string_view name, const Changes& changes = {}) {
  const SamplerPlugin& plugin = sampler_plugin(name);
  return plugin.make_points(changed(plugin.parameters, changes));
}

inline std::vector<Points::Entry> points_of(const PointSampler& sampler, const Pixel& pixel) {
  Points points;
  sampler.points(pixel, points);
  return {points.entries().begin(), points.entries().end()};
}

inline bool same_places(const std::vector<Points::Entry>& one, const std::vector<Points::Entry>& other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                    [](const auto& p, const auto& q) { return p.x == q.x && p.y == q.y; });
}

}  // namespace moire::test
