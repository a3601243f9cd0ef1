// What the experiment's README says of the paper's tables, held to on the real terrain. Needs the data folder.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <cstdlib>

#include "config/experiment.h"
#include "metrics/registry.h"
#include "run/contender.h"
#include "run/reference.h"
#include "sampling/lookups.h"
#include "support/plugins.h"

namespace moire {
namespace {

// M/V of one contender, against the exact content of the columns' lines.
double coverage_ratio(const SamplerChoice& sampler, const Frame& frame, const std::vector<MergedBlock>& exact,
                      const Settings& settings, const Workers& workers) {
  const auto metric = make_coverage(settings);
  metric->begin(frame.size());
  const Contender contender(sampler);
  workers.render(*contender.begin(frame, 1), frame, true,
                 [&](std::size_t index, const PixelBlock& block) { metric->block(block, exact[index]); });
  const Picture nothing{frame.size(), std::vector<Color>(static_cast<std::size_t>(frame.size().width) *
                                                         static_cast<std::size_t>(frame.size().height))};
  for (const Measurement& found : metric->finish({nothing, nothing, Counters{}})) {
    if (found.quantity == "coverage.ratio") return found.value;
  }
  return std::nan("");
}

TEST_CASE("in the paper's views point sampling covers what the paper says, and more points cover more") {
  if (!std::getenv("MOIRE_DATA")) SKIP("MOIRE_DATA is not set; point it at the data folder to test on Puget Sound");
  const Vocabulary vocabulary{&test::catalog(), metric_descriptions(), lookups()};
  const Experiment experiment = read_experiment(MOIRE_SOURCES "/experiments/cohen_or_coverage", vocabulary, {});
  const Workers workers(2);
  struct Expected {
    const char* scene;
    double point;  // Cohen-Or 1997, Tables 2 to 4
  };
  for (const auto& [name, point] :
       {Expected{"puget_sound pitch 40", .47}, {"puget_sound pitch 20", .29}, {"puget_sound pitch 5", .07}}) {
    CAPTURE(name);
    const SceneChoice* choice = nullptr;
    for (const SceneChoice& scene : experiment.scenes) {
      if (scene.name == name) choice = &scene;
    }
    REQUIRE(choice);
    const auto scene = choice->plugin->scene->make(choice->settings);
    const auto frame = scene->frame(choice->settings, experiment.image);
    const auto exact = exact_fragments(Against::column, {}, *frame, 0, 1, workers);
    double last = 0;
    for (const SamplerChoice& sampler : experiment.samplers) {
      CAPTURE(sampler.name);
      const double ratio = coverage_ratio(sampler, *frame, exact, experiment.metrics.front().settings, workers);
      if (sampler.name == "AS") {
        CHECK(ratio == 1);
      } else {
        CHECK(ratio > last);
        last = ratio;
      }
      if (sampler.name == "PS") CHECK(std::abs(ratio - point) <= .03);
    }
  }
}

}  // namespace
}  // namespace moire
