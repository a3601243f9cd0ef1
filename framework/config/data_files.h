// Finds the files that an experiment names.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "config/json_files.h"

namespace moire {

struct FoundFile {
  std::filesystem::path file;  // absolute; empty if there is none
  std::string problem;         // then this says why, to go on after `is "x.png", `
};

class DataFiles {
 public:
  // Reads the environment variable MOIRE_DATA.
  explicit DataFiles(const ExperimentPlace& place);

  // `data:terrain/x.png` lies in the folder MOIRE_DATA or in `data` of the project, anything else in `folder`.
  FoundFile find(std::string_view written, const std::filesystem::path& folder) const;

  static bool is_data(std::string_view written) { return written.starts_with("data:"); }

 private:
  FoundFile find_data(std::string_view name) const;

  const ExperimentPlace& place_;
  std::vector<std::filesystem::path> folders_;
  bool is_variable_set_ = false;
};

}  // namespace moire
