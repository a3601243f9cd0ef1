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

}  // namespace
}  // namespace moire::test
