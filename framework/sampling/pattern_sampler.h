// The host's part of a PointSampler: strands, lookups, fragments.
#pragma once

#include <memory>

#include <moire/plugin.h>

namespace moire {

// The sampler that a plugin makes from these settings; a PointSampler is given its host's part.
std::unique_ptr<Sampler> make_sampler(const SamplerPlugin& plugin, const Settings& settings);

}  // namespace moire
