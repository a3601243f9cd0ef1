// Where numbers come from: versions and hashes of program, plugins and data, compiler, machine, seed, date.
#pragma once

#include <map>
#include <span>
#include <string>

#include <nlohmann/json.hpp>

#include "config/experiment.h"

namespace moire {

// Content hashes of all files that a run depends on, each file read once.
class ContentHashes {
 public:
  // Error: a file cannot be read.
  const std::string& of(const std::filesystem::path& file);

 private:
  std::map<std::filesystem::path, std::string> known_;
};

// The data files that a scene's settings name.
std::vector<std::filesystem::path> data_files(const SceneChoice& scene);

// The key of a job: a hash of all that its result depends on, and of nothing else. `reference`: what the scene's
// contenders are judged against, whether the experiment names it or not.
std::string job_key(const Experiment& experiment, const SceneChoice& scene, const SamplerChoice& sampler,
                    const SamplerChoice& reference, ContentHashes& hashes);

// `command`: as the user gave it.
nlohmann::ordered_json make_manifest(const Experiment& experiment, std::span<const std::string> command, int threads,
                                     ContentHashes& hashes);

}  // namespace moire
