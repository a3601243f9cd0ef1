// A small project on disk for one test: `configs`, `data`, and one experiment in `edges`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "config/experiment.h"
#include "temporary_folder.h"

namespace moire::test {

// An experiment file: line 1 is {, 2 the question, 3 the image, 4 the scenes, 5 the samplers, 6 and on what else is
// given. `lines` such as `"seed": 3` replace those of the same key.
std::string experiment_with(const std::vector<std::string>& lines);

class ExperimentFolder {
 public:
  ExperimentFolder();

  // Reads this text as edges/experiment.json.
  Experiment read(std::string_view text, const Overrides& overrides = {}) const;
  // The message that it gives, with paths seen from the project. "(no error)" if there is none.
  std::string problems(std::string_view text, const Overrides& overrides = {}) const;

  std::string problems_with(const std::vector<std::string>& lines) const { return problems(experiment_with(lines)); }
  std::string problems_of_sets(const std::vector<std::string>& sets) const {
    return problems(experiment_with({}), {.sets = sets, .only = ""});
  }

  const std::filesystem::path& path() const { return folder_.path(); }
  std::filesystem::path file(std::string_view name, std::string_view bytes) const { return folder_.file(name, bytes); }

 private:
  TemporaryFolder folder_;
};

}  // namespace moire::test
