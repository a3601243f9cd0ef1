// Where plugins are looked for.
#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>

#include <moire/error.h>

#include "loading/catalog.h"

namespace moire {

namespace {

namespace fs = std::filesystem;

struct Named {
  fs::path folder;
  std::string_view by;
};

fs::path folder_beside_program() {
  return fs::canonical("/proc/self/exe").parent_path().parent_path() / "lib" / "moire" / "plugins";
}

std::vector<fs::path> split(std::string_view list) {
  std::vector<fs::path> parts;
  while (!list.empty()) {
    const std::string_view part = list.substr(0, list.find(':'));
    list.remove_prefix(std::min(part.size() + 1, list.size()));
    if (!part.empty()) parts.emplace_back(part);
  }
  return parts;
}

std::vector<Named> named_folders(std::span<const fs::path> extra) {
  std::vector<Named> named;
  const char* const variable = std::getenv("MOIRE_PLUGIN_PATH");
  for (const fs::path& folder : split(variable ? variable : "")) named.push_back({folder, "MOIRE_PLUGIN_PATH"});
  for (const fs::path& folder : extra) named.push_back({folder, "--plugins"});
  return named;
}

// A folder named twice would make every plugin its own double.
void add_once(std::vector<fs::path>& folders, const fs::path& folder) {
  const auto is_same = [&](const fs::path& other) { return fs::equivalent(other, folder); };
  if (std::none_of(folders.begin(), folders.end(), is_same)) folders.push_back(folder);
}

}  // namespace

std::vector<fs::path> plugin_folders(std::span<const fs::path> extra) {
  std::vector<fs::path> folders;
  if (const fs::path own = folder_beside_program(); fs::is_directory(own)) folders.push_back(own);
  std::string missing;
  for (const auto& [folder, by] : named_folders(extra)) {
    if (fs::is_directory(folder)) {
      add_once(folders, folder);
    } else {
      missing += fmt::format("{}{}: is no folder (\"{}\"); name one that has plugins in it",
                             missing.empty() ? "" : "\n", by, folder.string());
    }
  }
  if (!missing.empty()) throw Error(missing);
  return folders;
}

}  // namespace moire
