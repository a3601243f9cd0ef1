#include "run/content.h"

#include "run/hash.h"

namespace moire {

const std::string& ContentHashes::of(const std::filesystem::path& file) {
  const auto found = known_.find(file);
  return found != known_.end() ? found->second : known_.emplace(file, hash_of_file(file)).first->second;
}

std::vector<std::filesystem::path> data_files(const SceneChoice& scene) {
  std::vector<std::filesystem::path> files;
  for (const Parameter& parameter : scene.plugin->parameters()) {
    if (parameter.type != Type::file) continue;
    const std::string& file = scene.settings.text(parameter.name);
    if (!file.empty()) files.emplace_back(file);
  }
  return files;
}

nlohmann::ordered_json json_of(const Settings& settings) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const auto& [name, value] : settings.values()) std::visit([&](const auto& v) { json[name] = v; }, value);
  return json;
}

nlohmann::ordered_json content_of(const SceneChoice& scene, ContentHashes& hashes) {
  nlohmann::ordered_json settings = json_of(scene.settings);
  for (const Parameter& parameter : scene.plugin->parameters()) {
    if (parameter.type != Type::file) continue;
    const std::string& file = scene.settings.text(parameter.name);
    if (!file.empty()) settings[std::string(parameter.name)] = hashes.of(file);
  }
  return {scene.plugin->name, hashes.of(scene.plugin->file), std::move(settings)};
}

nlohmann::ordered_json content_of(const SamplerChoice& sampler, ContentHashes& hashes) {
  return {sampler.plugin->name, hashes.of(sampler.plugin->file), json_of(sampler.settings), sampler.lookup,
          sampler.filter,       json_of(sampler.options)};
}

}  // namespace moire
