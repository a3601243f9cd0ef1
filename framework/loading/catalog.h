// The plugins of this run: found in folders, checked as files, then opened.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <moire/plugin.h>

namespace moire {

// An opened plugin. What it refers to lives until the program ends.
struct Plugin {
  std::filesystem::path file;
  Kind kind = Kind::sampler;
  std::string name, version;
  const SamplerPlugin* sampler = nullptr;  // the one of the two that `kind` says
  const ScenePlugin* scene = nullptr;

  std::span<const Parameter> parameters() const { return sampler ? sampler->parameters : scene->parameters; }
  std::string_view summary() const { return sampler ? sampler->summary : scene->summary; }
  std::string_view source() const { return sampler ? sampler->source : scene->source; }
};

class Catalog {
 public:
  Catalog() = default;
  // Of plugins in memory, for tests. Requires: in the order of their names.
  explicit Catalog(std::vector<Plugin> plugins) : plugins_(std::move(plugins)) {}

  // Opens every *.so of the folders. Error: a folder that is missing, files that are no plugins of this interface, two
  // of one name; all of them in one message, a line each.
  static Catalog open(std::span<const std::filesystem::path> folders);

  const Plugin* find(Kind kind, std::string_view name) const;  // null if there is none
  std::vector<const Plugin*> all(Kind kind) const;             // by name

 private:
  std::vector<Plugin> plugins_;
};

// The folders to look in, each once: ../lib/moire/plugins beside the program if it exists, then each of
// MOIRE_PLUGIN_PATH (separated by ':'), then `extra` (of --plugins). Error: one of the latter two is no folder.
std::vector<std::filesystem::path> plugin_folders(std::span<const std::filesystem::path> extra);

}  // namespace moire
