// Entries that are left out where their plugins are not there.
#include <catch2/catch_test_macros.hpp>

#include "experiment_folder.h"

namespace moire::test {
namespace {

std::vector<std::string> names(const Experiment& experiment) {
  std::vector<std::string> result;
  for (const SamplerChoice& sampler : experiment.samplers) result.push_back(sampler.name);
  return result;
}

using Names = std::vector<std::string>;

TEST_CASE("a sampler that may be missing, and is, is left out with a note, whatever its settings") {
  const ExperimentFolder folder;
  const Experiment experiment = folder.read(experiment_with(
      {R"("samplers": ["point", {"type": "cairo", "if_installed": true, "label": "7", "mode": [1, 2]}, "bilinear"])"}));
  CHECK(names(experiment) == Names{"point", "bilinear"});
  CHECK(experiment.left_out == Names{"samplers[1]: \"cairo\" is left out: no such sampler is installed"});
  CHECK(experiment.request.at("samplers").size() == 2);
}

TEST_CASE("a sampler that may be missing, and is not, is as any other, and its request says so no more") {
  const ExperimentFolder folder;
  const Experiment experiment =
      folder.read(experiment_with({R"("samplers": [{"type": "supersample", "if_installed": true, "n": [2, 4]}])"}));
  CHECK(names(experiment) == Names{"supersample[n=2]", "supersample[n=4]"});
  CHECK(experiment.left_out.empty());
  CHECK_FALSE(experiment.request.at("samplers")[0].contains("if_installed"));
  CHECK(folder.problems_with({R"("samplers": [{"type": "supersample", "if_installed": true, "m": 2}])"}) !=
        "(no error)");
}

TEST_CASE("a sampler from a used file may be missing too") {
  const ExperimentFolder folder;
  folder.file("configs/cairo.json", R"({"type": "cairo", "if_installed": true})");
  const Experiment experiment =
      folder.read(experiment_with({R"("samplers": ["point", {"use": "configs/cairo.json"}])"}));
  CHECK(names(experiment) == Names{"point"});
  CHECK(experiment.left_out.size() == 1);
}

TEST_CASE("of samplers that may be missing one at least must be there") {
  const ExperimentFolder folder;
  CHECK(folder.problems_with({R"("samplers": [{"type": "cairo", "if_installed": true}])"}) ==
        "edges/experiment.json:5: samplers: has none that is installed; name one at least that is");
}

TEST_CASE("what is not marked must be there") {
  const ExperimentFolder folder;
  for (const char* mark : {"", R"(, "if_installed": false)"}) {
    const std::string problems =
        folder.problems_with({std::string(R"("samplers": ["point", {"type": "cairo")") + mark + "}]"});
    CHECK(problems.starts_with("edges/experiment.json:5: samplers[1].type: there is no sampler \"cairo\""));
  }
  CHECK(folder.problems_with({R"("samplers": [{"type": "cairo", "if_installed": 1}])"})
            .find("samplers[0].if_installed: is 1") != std::string::npos);
  CHECK(folder.problems_with({R"("reference": {"type": "point", "if_installed": true})"}) != "(no error)");
  CHECK(folder.problems_with({R"("scenes": [{"type": "heightfield", "if_installed": true}])"}) != "(no error)");
}

}  // namespace
}  // namespace moire::test
