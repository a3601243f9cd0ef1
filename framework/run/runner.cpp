#include "run/runner.h"

#include <cmath>
#include <functional>
#include <memory>
#include <mutex>

#include <fmt/format.h>

#include <moire/error.h>

#include "metrics/registry.h"
#include "run/detail_window.h"
#include "run/empty_sampler.h"
#include "run/manifest.h"
#include "run/progress.h"
#include "run/reference.h"
#include "run/speed.h"

namespace moire {

namespace {

std::vector<Explanation> explanations(const Experiment& experiment) {
  std::vector<Explanation> result;
  for (const MetricChoice& choice : experiment.metrics) {
    for (const Quantity& q : registered_metric(choice.name).description->quantities) {
      result.push_back({std::string(q.name), std::string(q.unit), std::string(q.meaning), q.lower_is_better,
                        q.is_judged, q.is_main});
    }
  }
  return result;
}

std::string_view unit_of(const MetricDescription& description, std::string_view quantity) {
  for (const Quantity& q : description.quantities) {
    if (q.name == quantity) return q.unit;
  }
  return "";
}

// The reference, the contenders, and timing if it is asked for.
std::size_t steps_a_scene(const Experiment& experiment) {
  std::size_t speeds = 0;
  for (const MetricChoice& metric : experiment.metrics) speeds += registered_metric(metric.name).make == nullptr;
  return 1 + experiment.samplers.size() + speeds;
}

// What went wrong, as a person can use it, whatever was thrown.
std::string message_of(const std::exception_ptr& thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    return "out of memory";
  } catch (const std::exception& e) {
    return e.what();
  } catch (...) {
    return "threw something that is no std::exception";
  }
}

// A scene, what it is judged against, and the jobs on it.
class SceneRun {
 public:
  SceneRun(const Experiment& experiment, const SceneChoice& choice, const Catalog& catalog, const Workers& workers,
           Sink& sink, Progress& progress, Results& results)
      : experiment_(experiment),
        choice_(choice),
        catalog_(catalog),
        workers_(workers),
        sink_(sink),
        progress_(progress),
        results_(results) {}

  void run(ContentHashes& hashes) {
    step(choice_.name, "reference", [&] { prepare(); });
    if (!frame_) {
      results_.failures.back().message += "; no contender ran on this scene";
      progress_.skip(steps_a_scene(experiment_) - 1);
      return sink_.save(results_);
    }
    for (const SamplerChoice& sampler : experiment_.samplers) {
      step(choice_.name, sampler.name, [&] {
        judge(sampler);
        results_.jobs[choice_.name + "/" + sampler.name] =
            job_key(experiment_, choice_, sampler, reference_choice_.sampler, hashes);
      });
    }
    if (!error_sum_.empty()) scene_result().detail_window = worst_window(error_sum_, experiment_.image);
    for (const MetricChoice& metric : experiment_.metrics) {
      if (!registered_metric(metric.name).make) step(choice_.name, "speed", [&] { time(metric.settings); });
    }
    sink_.save(results_);
  }

 private:
  // One piece of work: what it throws becomes a failure, and the run goes on.
  void step(const std::string& scene, const std::string& sampler, const std::function<void()>& work) {
    progress_.begin(scene + " / " + sampler);
    try {
      work();
    } catch (const Interrupted&) {
      throw;
    } catch (...) {
      const std::string message = message_of(std::current_exception());
      results_.failures.push_back({scene, sampler, message});
      progress_.note(fmt::format("{} / {}: failed: {}", scene, sampler, message));
    }
    progress_.end();
    sink_.save(results_);
  }

  SceneResult& scene_result() { return results_.scenes.back(); }

  void prepare() {
    const ScenePlugin& plugin = *choice_.plugin->scene;
    const Questions answered = plugin.answers(choice_.settings);
    reference_choice_ =
        experiment_.reference
            ? ReferenceChoice{*experiment_.reference, {}, experiment_.reference->plugin->sampler->claims.exact}
            : best_reference(catalog_, answered);
    scene_ = plugin.make(choice_.settings);
    const Settings exact = exact_settings(plugin, choice_.settings);
    exact_frame_ = scene_->frame(exact, experiment_.image);
    auto frame = scene_->frame(choice_.settings, experiment_.image);

    reference_ = make_reference(reference_choice_, exact_note(plugin), *exact_frame_, experiment_.seed, workers_);
    SceneResult& result = scene_result();
    result.reference = reference_.recipe;
    result.reference_error = reference_.error;
    result.reference_error_how = reference_.how;
    result.reference_image = sink_.picture(choice_.name, reference_folder, reference_.picture);
    frame_ = std::move(frame);
  }

  // "walk=grid, levels=none": the settings that the reference does not take from the experiment.
  static std::string exact_note(const ScenePlugin& plugin) {
    std::string note;
    for (const Parameter& parameter : plugin.parameters) {
      if (parameter.exact.empty()) continue;
      note += fmt::format("{}{}={}", note.empty() ? "" : ", ", parameter.name, parameter.exact);
    }
    return note;
  }

  const std::vector<MergedBlock>& exact_blocks(Against against) {
    std::vector<MergedBlock>& blocks = against == Against::column ? column_blocks_ : pixel_blocks_;
    if (blocks.empty()) blocks = exact_fragments(against, reference_choice_, *frame_, experiment_.seed, workers_);
    return blocks;
  }

  void judge(const SamplerChoice& sampler) {
    struct Pass {
      const RegisteredMetric* entry;
      std::unique_ptr<Metric> metric;
      const std::vector<MergedBlock>* exact = nullptr;
    };
    std::vector<Pass> passes;
    bool recording = false;
    for (const MetricChoice& choice : experiment_.metrics) {
      const RegisteredMetric& entry = registered_metric(choice.name);
      if (!entry.make) continue;
      passes.push_back({&entry, entry.make(choice.settings)});
      passes.back().metric->begin(experiment_.image);
      if (passes.back().metric->against() == Against::nothing) continue;
      passes.back().exact = &exact_blocks(passes.back().metric->against());
      recording = true;
    }

    const Contender contender(sampler);
    const auto pixels =
        static_cast<std::size_t>(experiment_.image.width) * static_cast<std::size_t>(experiment_.image.height);
    Picture picture{experiment_.image, std::vector<Color>(pixels)};
    std::vector<Counters> counters(workers_.blocks(experiment_.image));
    const auto rendering = contender.begin(*frame_, experiment_.seed);
    workers_.render(*rendering, experiment_.image, recording, [&](std::size_t index, const PixelBlock& block) {
      put(block, picture);
      counters[index] = block.counters;
      for (const Pass& pass : passes) {
        if (pass.exact) pass.metric->block(block, (*pass.exact)[index]);
      }
    });

    Counters sum;
    for (const Counters& block : counters) sum += block;
    results_.images.push_back(
        {choice_.name, sampler.name, "image", sink_.picture(choice_.name, sampler.name, picture)});
    for (const Pass& pass : passes) {
      for (const Measurement& m : pass.metric->finish({picture, reference_.picture, sum})) {
        results_.rows.push_back({choice_.name, sampler.name, std::string(m.quantity), m.value, m.low, m.high,
                                 std::string(unit_of(*pass.entry->description, m.quantity))});
      }
      for (const Map& map : pass.metric->maps()) {
        results_.images.push_back({choice_.name, sampler.name, std::string(map.kind),
                                   sink_.map(choice_.name, sampler.name, experiment_.image, map), map.scale});
        add_errors(map);
      }
    }
  }

  void add_errors(const Map& map) {
    if (map.kind != "error_absolute") return;
    error_sum_.resize(map.values.size());
    for (std::size_t k = 0; k < map.values.size(); ++k) error_sum_[k] += map.values[k];
  }

  void time(const Settings& settings) {
    std::vector<std::unique_ptr<Contender>> contenders;
    std::vector<Timed> timed;
    const auto add = [&](std::unique_ptr<Contender> contender, const Frame& frame, bool once) {
      contenders.push_back(std::move(contender));
      timed.push_back({contenders.back().get(), &frame, once});
    };
    add(std::make_unique<Contender>(floor_name, make_empty_sampler()), *frame_, false);
    for (const SamplerChoice& sampler : experiment_.samplers) {
      if (results_.jobs.contains(choice_.name + "/" + sampler.name))
        add(std::make_unique<Contender>(sampler), *frame_, false);
    }
    SamplerChoice ceiling = reference_choice_.sampler;
    ceiling.name = ceiling_name;
    add(std::make_unique<Contender>(ceiling), *exact_frame_, true);
    const auto rows = measure_speed(choice_.name, timed, settings, experiment_.seed, workers_,
                                    [&](double share) { progress_.advance(share); });
    results_.rows.insert(results_.rows.end(), rows.begin(), rows.end());
  }

  const Experiment& experiment_;
  const SceneChoice& choice_;
  const Catalog& catalog_;
  const Workers& workers_;
  Sink& sink_;
  Progress& progress_;
  Results& results_;

  ReferenceChoice reference_choice_;
  std::unique_ptr<Scene> scene_;
  std::unique_ptr<Frame> exact_frame_, frame_;
  Reference reference_;
  std::vector<MergedBlock> column_blocks_, pixel_blocks_;
  std::vector<double> error_sum_;
};

nlohmann::ordered_json chosen(const nlohmann::ordered_json& request, const char* list, std::size_t index) {
  nlohmann::ordered_json settings = request.at(list).at(index);
  for (const char* key : {"type", "label", "lookup"}) settings.erase(key);
  return settings;
}

}  // namespace

Results run_experiment(const Experiment& experiment, const Catalog& catalog, const Workers& workers, Sink& sink,
                       std::vector<std::string> command) {
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

  Progress progress(experiment.scenes.size() * steps_a_scene(experiment));
  try {
    for (std::size_t k = 0; k < experiment.scenes.size(); ++k) {
      const SceneChoice& scene = experiment.scenes[k];
      SceneResult& result = results.scenes.emplace_back();
      result.name = scene.name;
      result.type = scene.plugin->name;
      result.version = scene.plugin->version;
      result.settings = chosen(experiment.request, "scenes", k);
      result.summary = scene.plugin->summary();
      SceneRun(experiment, scene, catalog, workers, sink, progress, results).run(hashes);
    }
  } catch (const Interrupted&) {
    results.interrupted = true;
    sink.save(results);
  }
  return results;
}

}  // namespace moire
