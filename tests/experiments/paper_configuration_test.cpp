// The configurations of the paper's own choices: each choice set, and all else as in the fitted scene.
#include <catch2/catch_test_macros.hpp>
#include <cstdlib>

#include "config/experiment.h"
#include "metrics/registry.h"
#include "sampling/lookups.h"
#include "support/plugins.h"
#include "temporary_folder.h"

namespace moire {
namespace {

Experiment read(const std::string& scenes, const std::string& samplers) {
  const test::TemporaryFolder folder;
  const auto file =
      folder.file("experiment.json", R"({"question": "?", "image": {"width": 8, "height": 8}, "scenes": [)" + scenes +
                                         R"(], "samplers": [)" + samplers + "]}");
  const Vocabulary vocabulary{&test::catalog(), metric_descriptions(), lookups()};
  return read_experiment(file, vocabulary, {});
}

std::string use(const std::string& file) { return R"({"use": ")" MOIRE_SOURCES "/configs/" + file + "\"}"; }

}  // namespace

TEST_CASE("the paper's scene is the fitted one with the paper's choices") {
  if (!std::getenv("MOIRE_DATA")) SKIP("MOIRE_DATA is not set; the scenes name files of the data folder");
  const Experiment experiment =
      read(use("scenes/puget_sound.json") + "," +
               R"({"use": ")" MOIRE_SOURCES R"(/configs/scenes/paper.json", "label": "paper"})",
           R"("point")");
  Settings expected = experiment.scenes[0].settings;
  expected.set("azimuth", std::string("column"));
  expected.set("face", std::string("near"));
  expected.set("weights", std::string("height"));
  CHECK(experiment.scenes[1].settings == expected);
}

TEST_CASE("the paper's samplers look from lower edges and interpolate across") {
  const Experiment experiment =
      read(R"("heightfield")",
           use("samplers/paper_ps.json") + "," + use("samplers/paper_ss.json") + "," + use("samplers/paper_as.json"));
  CHECK(experiment.samplers[0].settings.text("rays") == "lower_edge");
  CHECK(experiment.samplers[1].settings.text("rays") == "lower_edge");
  CHECK(experiment.samplers[1].settings.text("layout") == "column");
  CHECK(experiment.samplers[2].settings.text("layout") == "upright");
  CHECK(experiment.samplers[2].settings.integer("lines") == 1);
  for (const SamplerChoice& sampler : experiment.samplers) CHECK(sampler.lookup == "linear_across");
}

}  // namespace moire
