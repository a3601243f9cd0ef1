#include "config/only.h"

#include <catch2/catch_test_macros.hpp>

#include "experiment_folder.h"

namespace moire::test {
namespace {

const std::string text = experiment_with(
    {R"("scenes": ["heightfield", {"type": "heightfield", "view": {"pitch_deg": -5}, "label": "flat"}, "cartoon"])",
     R"("samplers": ["point", {"type": "supersample", "n": [2, 4]}])"});

// "heightfield flat / point".
std::string left(const std::string& only) {
  const ExperimentFolder folder;
  const Experiment experiment = folder.read(text, {.sets = {}, .only = only});
  std::string names;
  for (const auto& scene : experiment.scenes) names += scene.name + " ";
  names += "/";
  for (const auto& sampler : experiment.samplers) names += " " + sampler.name;
  CHECK(experiment.request["scenes"].size() == experiment.scenes.size());
  CHECK(experiment.request["samplers"].size() == experiment.samplers.size());
  return names;
}

TEST_CASE("scenes and samplers are kept by name or by type") {
  CHECK(left("flat/supersample[n=4]") == "flat / supersample[n=4]");
  CHECK(left("cartoon/supersample") == "cartoon / supersample[n=2] supersample[n=4]");
  CHECK(left("heightfield/point") == "heightfield flat / point");
}

TEST_CASE("an empty half keeps all") {
  CHECK(left("/point") == "heightfield flat cartoon / point");
  CHECK(left("flat/") == "flat / point supersample[n=2] supersample[n=4]");
  CHECK(left("") == left("/"));
}

TEST_CASE("it is an error if nothing is left") {
  const ExperimentFolder folder;
  const auto problems = [&](const std::string& only) { return folder.problems(text, {.sets = {}, .only = only}); };
  CHECK(problems("flatt/quincunx") ==
        "--only flatt/quincunx: the experiment has no scene \"flatt\"; did you mean \"flat\"? it has "
        "heightfield, flat, cartoon\n"
        "--only flatt/quincunx: the experiment has no sampler \"quincunx\"; it has point, supersample[n=2], "
        "supersample[n=4]");
  CHECK(problems("point") == "--only point: has no \"/\"; write --only SCENE/SAMPLER, where one may be empty");
}

TEST_CASE("what is left out is checked all the same") {
  const ExperimentFolder folder;
  CHECK(folder.problems(experiment_with({R"("samplers": ["point", "pont"])"}), {.sets = {}, .only = "/point"}) ==
        "edges/experiment.json:5: samplers[1].type: there is no sampler \"pont\"; did you mean \"point\"? known are "
        "area, bilinear, jittered, point, supersample");
}

}  // namespace
}  // namespace moire::test
