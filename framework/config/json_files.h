// The JSON files of an experiment: the experiment itself, and the files that its entries `use`.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "json/json_tree.h"

namespace moire {

// Where an experiment lies.
struct ExperimentPlace {
  std::filesystem::path file;    // as the user gave it; of a folder, its experiment.json
  std::filesystem::path folder;  // absolute
  std::filesystem::path root;    // of the project: the nearest folder above that holds `configs`; empty if none does

  // A file as the user would write it, who gave the experiment's path as absolute or relative.
  std::filesystem::path as_given(const std::filesystem::path& absolute) const;
};

// Error: there is no experiment at `path`.
ExperimentPlace find_experiment(const std::filesystem::path& path);

// The whole text. Error: it cannot be read.
std::string read_text(const std::filesystem::path& file);

// Puts the members of the object in the used file under those that the entry has itself. An entry that cannot be
// completed becomes `broken`.
void resolve_use(JsonNode& entry, std::string_view path, const ExperimentPlace& place, Problems& problems);

}  // namespace moire
