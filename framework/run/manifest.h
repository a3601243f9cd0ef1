// Where numbers come from: versions and hashes of program, plugins and data, compiler, machine, seed, date.
#pragma once

#include <span>
#include <string>

#include <nlohmann/json.hpp>

#include "config/experiment.h"
#include "run/content.h"
#include "run/reference.h"

namespace moire {

// The key of a job: a hash of all that its result depends on, and of nothing else. `references`: what judges the
// scene's contenders, whether the experiment names it or not.
std::string job_key(const Experiment& experiment, const SceneChoice& scene, const SamplerChoice& sampler,
                    const References& references, ContentHashes& hashes);

// `command`: as the user gave it.
nlohmann::ordered_json make_manifest(const Experiment& experiment, std::span<const std::string> command, int threads,
                                     ContentHashes& hashes);

}  // namespace moire
