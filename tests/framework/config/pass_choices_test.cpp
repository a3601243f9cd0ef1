#include "config/pass_choices.h"

#include <catch2/catch_test_macros.hpp>

#include "experiment_folder.h"

namespace moire::test {
namespace {

TEST_CASE("metrics are names or objects, in the order of the file") {
  const ExperimentFolder folder;
  const auto metrics =
      folder.read(experiment_with({R"("metrics": ["speed", {"type": "coverage", "against": "pixel"}, "error"])"}))
          .metrics;
  REQUIRE(metrics.size() == 3);
  CHECK(metrics[0].name == "speed");
  CHECK(metrics[1].settings.text("against") == "pixel");
  CHECK(metrics[2].name == "error");
}

TEST_CASE("an experiment may do without metrics") {
  const ExperimentFolder folder;
  CHECK(folder.read(experiment_with({R"("metrics": [])"})).metrics.empty());
}

TEST_CASE("a metric is there once, since its rows are named after it, and has no grid") {
  const ExperimentFolder folder;
  CHECK(
      folder.problems_with({R"("metrics": ["coverage", "speed",
    {"type": "coverage", "against": "column"}, {"type": "coverage", "against": ["pixel"]},
    "sped", {"type": "error", "label": "x"}, 3])"}) ==
      "edges/experiment.json:7: metrics[2]: is a second \"coverage\" (the first is metrics[0], line 6), whose numbers "
      "would have the same names; remove one of them\n"
      "edges/experiment.json:7: metrics[3]: is a second \"coverage\" (the first is metrics[0], line 6), whose numbers "
      "would have the same names; remove one of them\n"
      "edges/experiment.json:7: metrics[3].against: is a list; it takes one value here\n"
      "edges/experiment.json:8: metrics[4].type: there is no metric \"sped\"; did you mean \"speed\"? known are "
      "coverage, error, speed\n"
      "edges/experiment.json:8: metrics[5].label: unknown key; \"error\" takes no parameters\n"
      "edges/experiment.json:8: metrics[6]: is 3; a metric is a name, or an object with a \"type\"");
}

TEST_CASE("an experiment has no pictures unless it asks for some, and any number of each") {
  const ExperimentFolder folder;
  CHECK(folder.read(experiment_with({})).pictures.empty());
  const auto pictures =
      folder
          .read(experiment_with({R"("frames": {"count": 2})",
                                 R"("pictures": ["strip", {"type": "strip", "column": 9}, "plan", "strip"])"}))
          .pictures;
  REQUIRE(pictures.size() == 4);
  CHECK(pictures[0].settings.integer("column") == 0);
  CHECK(pictures[1].settings.integer("column") == 9);
  CHECK(pictures[2].name == "plan");
  CHECK(pictures[3].name == "strip");
}

TEST_CASE("what is wrong with pictures is said like what is wrong with metrics") {
  const ExperimentFolder folder;
  CHECK(folder.problems_with({R"("frames": {"count": 2})", R"("pictures": ["stirp",
    {"type": "strip", "column": 64}, {"type": "strip", "column": -1}, {"type": "plan", "x": 1}])"}) ==
        "edges/experiment.json:7: pictures[0].type: there is no picture \"stirp\"; did you mean \"strip\"? known are "
        "plan, strip\n"
        "edges/experiment.json:8: pictures[2].column: is -1; \"strip\" takes 0 to 16383\n"
        "edges/experiment.json:8: pictures[3].x: unknown key; \"plan\" takes no parameters\n"
        "edges/experiment.json:8: pictures[1]: leaves the image");
  CHECK(folder.problems_with({R"("pictures": "strip")"}) == "edges/experiment.json:6: pictures[0]: needs two frames");
  // The count is wrong and said to be; how many frames were meant is not known.
  CHECK(folder.problems_with({R"("pictures": "strip")", R"("frames": {"count": 0})"}) ==
        "edges/experiment.json:7: frames.count: is 0; \"frames\" takes 1 to 1000000 frames");
}

TEST_CASE("a picture that asks what a scene does not answer is refused with the scenes that would do") {
  const ExperimentFolder folder;
  CHECK(
      folder.problems_with({R"("pictures": "plan")", R"("scenes": ["heightfield", "cartoon"])"}) ==
      "edges/experiment.json:6: pictures[0]: \"plan\" asks for places on a texture, which scene \"cartoon\" (cartoon) "
      "does not have; scenes that do: heightfield, textured_plane");
}

}  // namespace
}  // namespace moire::test
