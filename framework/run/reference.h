// What contenders are judged against, and why it can be trusted.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "metrics/merged.h"
#include "metrics/metric.h"
#include "run/contender.h"

namespace moire {

// How a reference is made: a sampler, and a weaker form of it to judge it by.
struct ReferenceChoice {
  SamplerChoice sampler;
  std::optional<SamplerChoice> half;  // half as many lines or points; none: a sampler that the experiment names
  bool is_exact = false;
};

// The best that any sampler offers for a scene with these answers. Error: none offers anything.
ReferenceChoice best_reference(const Catalog& catalog, Questions answered);

// The scene's settings, with those under which it is exact.
Settings exact_settings(const ScenePlugin& scene, Settings settings);

struct Reference {
  std::string recipe;  // "area[lines=32,layout=radial]; walk=grid, levels=none"
  Picture picture;
  double error = 0;  // rmse in levels, linear light; NaN: unknown
  std::string how;   // how `error` was got
};

// `frame` has the scene's exact settings.
Reference make_reference(const ReferenceChoice& choice, const std::string& scene_note, const Frame& frame,
                         int frame_number, std::uint64_t seed, const Workers& workers);

// The exact fragments that coverage is held against, block by block.
std::vector<MergedBlock> exact_fragments(Against against, const ReferenceChoice& choice, const Frame& frame,
                                         int frame_number, std::uint64_t seed, const Workers& workers);

}  // namespace moire
