// What the experiment's README says of Table 6, held to over the first frames. Needs the data folder.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cstdlib>
#include <map>

#include "config/experiment.h"
#include "metrics/registry.h"
#include "pictures/registry.h"
#include "run/frame_run.h"
#include "sampling/filters.h"
#include "sampling/lookups.h"
#include "support/plugins.h"

namespace moire {
namespace {

// flicker.excess of every contender over `count` frames of a scene.
std::map<std::string, double> excess(const Experiment& experiment, const SceneChoice& choice, int count) {
  const auto scene = choice.plugin->scene->make(choice.settings);
  const auto at = [&](int frame) { return settings_at(choice.settings, experiment.frames, frame); };
  const FrameSource source{
      *scene,           at,    [&](int frame) { return exact_settings(*choice.plugin->scene, at(frame)); },
      experiment.image, count, experiment.frames.still,
      experiment.seed};
  const Settings& settings = experiment.metrics.back().settings;
  std::vector<Watched> watched;
  for (const SamplerChoice& sampler : experiment.samplers) {
    Watched& w = watched.emplace_back(Watched{sampler.name, std::make_unique<Contender>(sampler), {}, ""});
    w.passes.push_back(make_flicker(settings, experiment.image));
  }
  const References references = choose_references({}, test::catalog(), choice);
  run_frames(source, references, watched, Workers(2), [](double) {});
  std::map<std::string, double> result;
  for (const Watched& w : watched) {
    for (const Measurement& m : static_cast<const TemporalMetric&>(*w.passes.front()).finish()) {
      if (m.quantity == "flicker.excess") result[w.name] = m.value;
    }
  }
  return result;
}

TEST_CASE("point sampling flickers most, supersampling less the more points it has, area sampling least") {
  if (!std::getenv("MOIRE_DATA")) SKIP("MOIRE_DATA is not set; point it at the data folder to test on Puget Sound");
  const Vocabulary vocabulary{&test::catalog(), metric_descriptions(), lookups(), picture_descriptions(), filters()};
  const Experiment experiment = read_experiment(MOIRE_SOURCES "/experiments/cohen_or_flicker", vocabulary, {});
  for (const SceneChoice& scene : experiment.scenes) {
    CAPTURE(scene.name);
    const auto found = excess(experiment, scene, 24);
    CHECK(found.at("PS") > found.at("SS[n=8]"));
    CHECK(found.at("SS[n=8]") > found.at("SS[n=16]"));
    CHECK(found.at("SS[n=16]") > found.at("AS"));
    CHECK(found.at("AS") > 0);
  }
}

}  // namespace
}  // namespace moire
