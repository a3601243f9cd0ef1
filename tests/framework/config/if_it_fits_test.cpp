// Samplers that are left out on scenes that they do not fit.
#include <catch2/catch_test_macros.hpp>
#include <map>

#include "experiment_folder.h"

namespace moire::test {
namespace {

using Missing = std::map<std::string, std::string>;

constexpr const char* two_scenes = R"("scenes": [{"type": "heightfield"}, {"type": "cartoon"}])";

TEST_CASE("a sampler that need not fit is left out on the scenes that it does not fit, and its request says so") {
  const ExperimentFolder folder;
  const Experiment experiment =
      folder.read(experiment_with({two_scenes, R"("samplers": ["point", {"type": "bilinear", "if_it_fits": true}])"}));
  REQUIRE(experiment.samplers.size() == 2);
  REQUIRE(experiment.scenes.size() == 2);
  CHECK(experiment.scenes[0].without.empty());
  CHECK(experiment.scenes[1].without == Missing{{"bilinear", "places on a texture (for its lookup, bilinear)"}});
  CHECK(experiment.request.at("samplers")[1].at("if_it_fits") == true);
}

TEST_CASE("a sampler that is not marked must fit all scenes") {
  const ExperimentFolder folder;
  for (const char* mark : {"", R"(, "if_it_fits": false)"}) {
    const std::string problems =
        folder.problems_with({two_scenes, std::string(R"("samplers": ["point", {"type": "bilinear")") + mark + "}]"});
    CHECK(problems.find("asks for places on a texture") != std::string::npos);
  }
  CHECK(folder.problems_with({R"("samplers": [{"type": "point", "if_it_fits": 1}])"})
            .find("samplers[0].if_it_fits: is 1") != std::string::npos);
}

}  // namespace
}  // namespace moire::test
