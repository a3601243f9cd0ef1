#include "run/runner.h"

#include <set>

#include "metrics/registry.h"
#include "run/budget_analysis.h"
#include "run/convergence_analysis.h"
#include "run/cost_analysis.h"
#include "run/manifest.h"
#include "run/scene_run.h"

namespace moire {

namespace {

std::vector<Explanation> explanations(const Experiment& experiment) {
  std::vector<Explanation> result;
  for (const PassChoice& choice : experiment.metrics) {
    for (const Quantity& q : registered_metric(choice.name).description->quantities) {
      result.push_back({std::string(q.name), std::string(q.unit), std::string(q.meaning), q.lower_is_better,
                        q.is_judged, q.is_main});
    }
  }
  return result;
}

nlohmann::ordered_json chosen(const nlohmann::ordered_json& request, const char* list, std::size_t index) {
  nlohmann::ordered_json settings = request.at(list).at(index);
  for (const char* key : {"type", "label", "lookup", "if_it_fits"}) settings.erase(key);
  return settings;
}

}  // namespace

Results run_experiment(const Experiment& experiment, const Catalog& catalog, const Workers& workers, Sink& sink,
                       const ReferenceStore& store, std::vector<std::string> command) {
  ContentHashes hashes;
  Results results;
  results.experiment = experiment.name;
  results.question = experiment.question;
  results.width = experiment.image.width;
  results.height = experiment.image.height;
  results.metrics = explanations(experiment);
  results.manifest = make_manifest(experiment, command, workers.threads(), hashes);
  for (std::size_t k = 0; k < experiment.samplers.size(); ++k) {
    const SamplerChoice& sampler = experiment.samplers[k];
    results.contenders.push_back({sampler.name, sampler.plugin->name, sampler.plugin->version, sampler.lookup,
                                  chosen(experiment.request, "samplers", k), std::string(sampler.plugin->summary()),
                                  std::string(sampler.plugin->source())});
  }

  Shared shared(store);
  std::size_t steps = 0;
  for (const SceneChoice& scene : experiment.scenes) steps += steps_on(scene, experiment);
  Progress progress(steps);
  const SceneContext context{experiment, catalog, shared, workers, sink, progress, hashes};
  try {
    for (std::size_t k = 0; k < experiment.scenes.size(); ++k) {
      const SceneChoice& scene = experiment.scenes[k];
      SceneResult& result = results.scenes.emplace_back();
      result.name = scene.name;
      result.type = scene.plugin->name;
      result.version = scene.plugin->version;
      result.settings = chosen(experiment.request, "scenes", k);
      result.summary = scene.plugin->summary();
      result.without = scene.without;
      run_scene(scene, context, results);
    }
    std::set<std::string> on_lines;
    for (const SamplerChoice& sampler : experiment.samplers) {
      const Questions asked = sampler.plugin->sampler->asks(sampler.settings);
      if ((asked & (Questions::lines | Questions::radial_lines)) != Questions::none) on_lines.insert(sampler.name);
    }
    for (const PassChoice& metric : experiment.metrics) {
      if (metric.name == cost_description.name) analyse_cost(metric.settings, on_lines, results);
      if (metric.name == budget_description.name) analyse_budgets(metric.settings, results);
      if (metric.name == convergence_description.name) analyse_convergence(metric.settings, results);
    }
  } catch (const Interrupted&) {
    results.interrupted = true;
  }
  sink.save(results);
  return results;
}

}  // namespace moire
