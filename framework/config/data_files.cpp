// Looks files up beside the JSON file that names them, and `data:` files in the data folders.
#include "config/data_files.h"

#include <cstdlib>
#include <system_error>

#include <fmt/format.h>

namespace moire {
namespace fs = std::filesystem;

namespace {

// Why this cannot be read as a file; empty if it can.
std::string file_problem(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (fs::is_directory(status)) return "a folder";
  if (fs::is_regular_file(status)) return "";
  return fs::exists(status) ? "no regular file" : "but there is no such file";
}

}  // namespace

DataFiles::DataFiles(const ExperimentPlace& place) : place_(place) {
  const char* const variable = std::getenv("MOIRE_DATA");
  is_variable_set_ = variable != nullptr && *variable != '\0';
  if (is_variable_set_) folders_.push_back(fs::absolute(variable).lexically_normal());
  if (!place.root.empty()) folders_.push_back(place.root / "data");
}

FoundFile DataFiles::find(std::string_view written, const fs::path& folder) const {
  if (is_data(written)) return find_data(written.substr(5));
  const fs::path file = (folder / written).lexically_normal();
  const std::string problem = file_problem(file);
  if (problem.empty()) return {file, ""};
  return {{}, fmt::format("{} (looked for {})", problem, place_.as_given(file).string())};
}

FoundFile DataFiles::find_data(std::string_view name) const {
  std::string looked;
  for (const fs::path& folder : folders_) {
    const fs::path file = (folder / fs::path(name).relative_path()).lexically_normal();
    if (file_problem(file).empty()) return {file, ""};
    looked += (looked.empty() ? "looked in " : " and ") + place_.as_given(folder).string();
  }
  if (!is_variable_set_) looked += std::string(looked.empty() ? "" : "; ") + "MOIRE_DATA is not set";
  return {{}, fmt::format("but there is no such file ({}); MOIRE_DATA should point at the data folder", looked)};
}

}  // namespace moire
