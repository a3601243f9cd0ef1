#include <catch2/catch_test_macros.hpp>

#include "experiment_folder.h"
#include "vocabulary.h"

namespace moire::test {
namespace {

TEST_CASE("pairs that fit have nothing to say") {
  const ExperimentFolder folder;
  const Experiment experiment = folder.read(experiment_with({R"("samplers": ["point", "area", "bilinear"])"}));
  for (const auto& sampler : experiment.samplers) CHECK(mismatch(experiment.scenes[0], sampler, vocabulary()) == "");
}

TEST_CASE("a sampler that asks what a scene cannot answer is refused with the scenes that would do") {
  const ExperimentFolder folder;
  CHECK(folder.problems_with({R"("scenes": [{"type": "textured_plane", "label": "plane"}, "heightfield"])",
                              R"("samplers": ["point", {"type": "area", "layout": "radial"}])",
                              R"("reference": {"type": "area", "method": "exact"})"}) ==
        "edges/experiment.json:5: samplers[1]: \"area[layout=radial]\" asks for lines through a common point, which "
        "scene \"plane\" (textured_plane) does not have; scenes that do: heightfield\n"
        "edges/experiment.json:6: reference: \"area[method=exact]\" asks for polygons, which scene \"plane\" "
        "(textured_plane) does not have; scenes that do: cartoon\n"
        "edges/experiment.json:6: reference: \"area[method=exact]\" asks for polygons, which scene \"heightfield\" "
        "(heightfield) does not have; scenes that do: cartoon");
}

TEST_CASE("a lookup asks too, unless it is the first") {
  const ExperimentFolder folder;
  CHECK(
      folder.problems_with(
          {R"("scenes": ["cartoon"])",
           R"("samplers": ["bilinear", {"type": "area", "method": "exact", "lookup": "bilinear"}])"}) ==
      "edges/experiment.json:5: samplers[0]: \"bilinear\" asks for places on a texture (for its lookup, bilinear), "
      "which scene \"cartoon\" (cartoon) does not have; scenes that do: heightfield, textured_plane\n"
      "edges/experiment.json:5: samplers[1]: \"area[method=exact,lookup=bilinear]\" asks for places on a texture (for "
      "its lookup, bilinear), which scene \"cartoon\" (cartoon) does not have; no known scene does");
}

TEST_CASE("a metric asks too, of every scene") {
  const ExperimentFolder folder;
  const std::string scenes = R"("scenes": [{"type": "textured_plane", "label": "plane"}, "heightfield"])";
  CHECK(folder.problems_with({scenes, R"("metrics": ["error", {"type": "coverage", "against": "column"}])"}) ==
        "edges/experiment.json:6: metrics[1]: \"coverage\" asks for lines, which scene \"plane\" (textured_plane) does "
        "not "
        "have; scenes that do: cartoon, heightfield");
  CHECK(folder.problems_with({scenes, R"("metrics": ["error", {"type": "coverage", "against": "pixel"}])"}) ==
        "(no error)");
}

}  // namespace
}  // namespace moire::test
