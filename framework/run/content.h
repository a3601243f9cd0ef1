// What results depend on, as JSON from which keys are made: contents of files, not where they lie, and no labels.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "config/experiment.h"

namespace moire {

// Content hashes of all files that a run depends on, each file read once.
class ContentHashes {
 public:
  // Error: a file cannot be read.
  const std::string& of(const std::filesystem::path& file);
  const std::string& of_program() { return of("/proc/self/exe"); }

 private:
  std::map<std::filesystem::path, std::string> known_;
};

// The data files that a scene's settings name.
std::vector<std::filesystem::path> data_files(const SceneChoice& scene);

nlohmann::ordered_json json_of(const Settings& settings);

// Plugin and settings, files replaced by what is in them. Error: a file cannot be read.
nlohmann::ordered_json content_of(const SceneChoice& scene, ContentHashes& hashes);
nlohmann::ordered_json content_of(const SamplerChoice& sampler, ContentHashes& hashes);

}  // namespace moire
