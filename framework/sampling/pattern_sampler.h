// The host's part of a PointSampler: strands, lookups, fragments.
#pragma once

#include <memory>
#include <string>

#include <moire/plugin.h>

namespace moire {

// A filter and its settings.
struct FilterChoice {
  std::string name = "box";  // a name from filters()
  Settings settings = {};    // what is missing has its default
};

// The sampler that a plugin makes from these settings; a PointSampler is given its host's part, which heeds the filter.
std::unique_ptr<Sampler> make_sampler(const SamplerPlugin& plugin, const Settings& settings,
                                      const FilterChoice& filter = {});

}  // namespace moire
