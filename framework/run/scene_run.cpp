#include "run/scene_run.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include <fmt/format.h>

#include <moire/error.h>

#include "metrics/registry.h"
#include "pictures/registry.h"
#include "run/detail_window.h"
#include "run/empty_sampler.h"
#include "run/failure_message.h"
#include "run/frame_run.h"
#include "run/manifest.h"
#include "run/reference.h"
#include "run/speed.h"

namespace moire {

namespace {

std::string_view unit_of(const PassDescription& description, std::string_view quantity) {
  for (const Quantity& q : description.quantities) {
    if (q.name == quantity) return q.unit;
  }
  return "";
}

bool has_frame_passes(const Experiment& experiment) {
  return !experiment.pictures.empty() ||
         std::any_of(experiment.metrics.begin(), experiment.metrics.end(),
                     [](const PassChoice& metric) { return registered_metric(metric.name).make_temporal != nullptr; });
}

// The contenders on a scene.
std::vector<const SamplerChoice*> samplers_on(const SceneChoice& scene, const Experiment& experiment) {
  std::vector<const SamplerChoice*> result;
  for (const SamplerChoice& sampler : experiment.samplers) {
    if (!scene.without.contains(sampler.name)) result.push_back(&sampler);
  }
  return result;
}

// A scene, what it is judged against, and the jobs on it.
class SceneRun {
 public:
  SceneRun(const SceneChoice& choice, const SceneContext& context, Results& results)
      : experiment_(context.experiment),
        choice_(choice),
        catalog_(context.catalog),
        shared_(context.shared),
        workers_(context.workers),
        sink_(context.sink),
        progress_(context.progress),
        hashes_(context.hashes),
        results_(results) {}

  void run() {
    step("reference", [&] { prepare(); });
    if (!frame_) {
      results_.failures.back().message += "; no contender ran on this scene";
      progress_.skip(steps_on(choice_, experiment_) - 1);
      return sink_.save(results_);
    }
    for (const SamplerChoice* contender : samplers_on(choice_, experiment_)) {
      const SamplerChoice& sampler = *contender;
      step(sampler.name, [&] {
        judge(sampler);
        results_.jobs[choice_.name + "/" + sampler.name] = job_key(experiment_, choice_, sampler, references_, hashes_);
      });
    }
    if (!error_sum_.empty()) scene_result().detail_window = worst_window(error_sum_, experiment_.image);
    if (has_frame_passes(experiment_)) step("frames", [&] { watch_frames(); });
    for (const PassChoice& metric : experiment_.metrics) {
      if (registered_metric(metric.name).is_timing()) step("speed", [&] { time(metric.settings); });
    }
    sink_.save(results_);
  }

 private:
  // One piece of work: what it throws becomes a failure, and the run goes on.
  void step(const std::string& sampler, const std::function<void()>& work) {
    progress_.begin(choice_.name + " / " + sampler);
    try {
      work();
    } catch (const Interrupted&) {
      throw;
    } catch (...) {
      note_failure(sampler, failure_message(std::current_exception()));
    }
    progress_.end();
    sink_.save(results_);
  }

  void note_failure(const std::string& sampler, const std::string& message) {
    results_.failures.push_back({choice_.name, sampler, message});
    progress_.note(fmt::format("{} / {}: failed: {}", choice_.name, sampler, message));
  }

  SceneResult& scene_result() { return results_.scenes.back(); }

  void prepare() {
    references_ = choose_references(experiment_.reference, catalog_, choice_);
    scene_ = &shared_.scene(choice_);
    const int still = experiment_.frames.still;
    auto frame = scene_->frame(settings_at(choice_.settings, experiment_.frames, still), experiment_.image);

    SceneChoice exact = choice_;
    exact.settings = exact_settings_at(still);
    const ReferenceRequest request{.choice = references_.colors,
                                   .scene = exact,
                                   .changes = exact_note(*choice_.plugin->scene, choice_.settings),
                                   .image = experiment_.image,
                                   .frame_number = still,
                                   .seed = experiment_.seed};
    reference_ = shared_.reference(request, hashes_, workers_);
    progress_.note(fmt::format("{}: reference {}: {} ({})", choice_.name, reference_.recipe,
                               trust_in(reference_, references_.colors), reference_.origin));
    SceneResult& result = scene_result();
    result.reference = reference_.recipe;
    result.reference_error = reference_.error;
    result.reference_error_how = reference_.how;
    result.reference_origin = reference_.origin;
    results_.manifest["references"][choice_.name] = {
        {"recipe", result.reference}, {"how", result.reference_error_how}, {"origin", result.reference_origin}};
    if (experiment_.keep_images)
      result.reference_image = sink_.picture(choice_.name, reference_folder, reference_.picture);
    frame_ = std::move(frame);
  }

  Settings exact_settings_at(int frame) const {
    return exact_settings(*choice_.plugin->scene, settings_at(choice_.settings, experiment_.frames, frame));
  }

  const std::vector<MergedBlock>& exact_blocks(Against against) {
    if (against == Against::pixel) say_what_fragments_are_held_against();
    std::vector<MergedBlock>& blocks = against == Against::column ? column_blocks_ : pixel_blocks_;
    if (blocks.empty()) {
      blocks = exact_fragments(against, references_.fragments, *frame_, experiment_.frames.still, experiment_.seed,
                               workers_);
    }
    return blocks;
  }

  void say_what_fragments_are_held_against() {
    const std::string& fragments = references_.fragments.sampler.name;
    if (fragments != references_.colors.sampler.name) scene_result().fragments_reference = fragments;
  }

  void judge(const SamplerChoice& sampler) {
    struct Pass {
      const RegisteredMetric* entry;
      std::unique_ptr<Metric> metric;
      const std::vector<MergedBlock>* exact = nullptr;
    };
    std::vector<Pass> passes;
    bool recording = false;
    for (const PassChoice& choice : experiment_.metrics) {
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
    const auto rendering = contender.begin(*frame_, experiment_.seed, experiment_.frames.still);
    std::vector<Counters> counters(workers_.blocks(experiment_.image, Workers::order(*rendering, recording)));
    workers_.render(*rendering, *frame_, recording, [&](std::size_t index, const PixelBlock& block) {
      put(block, picture);
      counters[index] = block.counters;
      for (const Pass& pass : passes) {
        if (pass.exact) pass.metric->block(block, (*pass.exact)[index]);
      }
    });

    Counters sum;
    for (const Counters& block : counters) sum += block;
    if (experiment_.keep_images) {
      results_.images.push_back(
          {choice_.name, sampler.name, "image", sink_.picture(choice_.name, sampler.name, picture)});
    }
    std::size_t replicates = 0;
    for (const Pass& pass : passes) replicates = std::max(replicates, pass.metric->replicates());
    const auto others = render_replicates(contender, sampler, replicates);
    const SamplerPlugin& plugin = *sampler.plugin->sampler;
    const auto points = plugin.make_points ? plugin.make_points(sampler.settings) : nullptr;
    const Judged judged{.picture = picture,
                        .reference = reference_.picture,
                        .counters = sum,
                        .frame = frame_.get(),
                        .points = points.get(),
                        .seed = experiment_.seed,
                        .replicates = others};
    for (const Pass& pass : passes) {
      add_rows(sampler.name, *pass.entry->description, pass.metric->finish(judged));
      for (const Map& map : pass.metric->maps()) {
        results_.images.push_back({choice_.name, sampler.name, std::string(map.kind),
                                   sink_.map(choice_.name, sampler.name, experiment_.image, map), map.scale});
        add_errors(map);
      }
      add_curves(sampler.name, *pass.entry->description, pass.metric->curves());
    }
  }

  // With random numbers of their own each, which no other contender has. None of methods that draw none.
  std::vector<Picture> render_replicates(const Contender& contender, const SamplerChoice& sampler,
                                         std::size_t count) const {
    std::vector<Picture> result;
    if (sampler.plugin->sampler->claims.deterministic) return result;
    std::uint64_t seed = mixed(experiment_.seed);
    for (const char c : sampler.name) seed = mixed(seed + static_cast<unsigned char>(c) + 1);
    while (result.size() < count) {
      seed = mixed(seed + result.size() + 1);
      result.push_back(render_picture(contender, *frame_, experiment_.frames.still, seed, workers_));
    }
    return result;
  }

  // A contender of name `name`, null for the reference, with its passes over frames.
  Watched watched(const std::string& name, std::unique_ptr<Contender> contender) const {
    Watched result{name, std::move(contender), {}, {}};
    for (const PassChoice& metric : experiment_.metrics) {
      if (const auto make = registered_metric(metric.name).make_temporal)
        result.passes.push_back(make(metric.settings, experiment_.image));
    }
    for (const PassChoice& picture : experiment_.pictures) {
      result.passes.push_back(
          registered_picture(picture.name).make(picture.settings, {experiment_.image, experiment_.frames.count}));
    }
    if (!result.contender) {
      for (auto& pass : result.passes) {
        if (!pass->needs().of_reference) pass.reset();
      }
    }
    return result;
  }

  void watch_frames() {
    std::vector<Watched> all;
    all.push_back(watched(reference_name, nullptr));
    for (const SamplerChoice* contender : samplers_on(choice_, experiment_)) {
      const SamplerChoice& sampler = *contender;
      if (results_.jobs.contains(choice_.name + "/" + sampler.name))
        all.push_back(watched(sampler.name, std::make_unique<Contender>(sampler)));
    }
    for (const auto& pass : all.back().passes) {
      if (pass && pass->needs().exact) say_what_fragments_are_held_against();
    }
    const FrameSource source{*scene_,
                             [&](int frame) { return settings_at(choice_.settings, experiment_.frames, frame); },
                             [&](int frame) { return exact_settings_at(frame); },
                             experiment_.image,
                             experiment_.frames.count,
                             experiment_.frames.still,
                             experiment_.seed};
    run_frames(source, references_, all, workers_, [&](double share) { progress_.advance(share); });
    for (const Watched& w : all) {
      if (w.failure.empty()) {
        keep(w);
      } else {
        note_failure(w.name, w.failure);
      }
    }
  }

  void keep(const Watched& w) {
    auto pass = w.passes.begin();
    for (const PassChoice& metric : experiment_.metrics) {
      const RegisteredMetric& entry = registered_metric(metric.name);
      if (!entry.make_temporal) continue;
      if (const auto* temporal = static_cast<const TemporalMetric*>((pass++)->get()))
        add_rows(w.name, *entry.description, temporal->finish());
    }
    for (std::size_t k = 0; k < experiment_.pictures.size(); ++k) {
      const auto* picture = static_cast<const PicturePass*>((pass++)->get());
      if (picture) keep(*picture, picture_kind(k), w);
    }
  }

  // A picture that cannot be drawn costs no other one.
  void keep(const PicturePass& picture, const std::string& kind, const Watched& w) {
    try {
      const Drawing drawing = picture.finish();
      const std::string folder = w.contender ? w.name : reference_folder;
      const auto file = sink_.drawing(choice_.name, folder, kind, drawing.picture);
      results_.images.push_back({choice_.name, w.name, kind, file, 0, drawing.caption});
    } catch (const std::exception&) {
      note_failure(w.name, failure_message(std::current_exception()));
    }
  }

  // "footprint", or "footprint_2" for the second of several.
  std::string picture_kind(std::size_t index) const {
    const std::string& name = experiment_.pictures[index].name;
    const auto is_same = [&](const PassChoice& picture) { return picture.name == name; };
    const auto begin = experiment_.pictures.begin();
    if (std::count_if(begin, experiment_.pictures.end(), is_same) == 1) return name;
    return fmt::format("{}_{}", name, 1 + std::count_if(begin, begin + static_cast<std::ptrdiff_t>(index), is_same));
  }

  void add_rows(const std::string& sampler, const PassDescription& description,
                const std::vector<Measurement>& measurements) {
    for (const Measurement& m : measurements) {
      results_.rows.push_back({choice_.name, sampler, std::string(m.quantity), m.value, m.low, m.high,
                               std::string(unit_of(description, m.quantity))});
    }
  }

  void add_curves(const std::string& sampler, const PassDescription& description, const std::vector<Curve>& curves) {
    for (const Curve& curve : curves) {
      const auto about = std::find_if(description.curves.begin(), description.curves.end(),
                                      [&](const CurveDescription& c) { return c.name == curve.kind; });
      CurveResult& result = results_.curves.emplace_back(CurveResult{choice_.name,
                                                                     sampler,
                                                                     std::string(curve.kind),
                                                                     std::string(about->title),
                                                                     std::string(about->x_axis),
                                                                     std::string(about->y_axis),
                                                                     {}});
      for (const Point& p : curve.points) result.points.push_back({p.x, p.y});
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
    for (const SamplerChoice* contender : samplers_on(choice_, experiment_)) {
      const SamplerChoice& sampler = *contender;
      if (results_.jobs.contains(choice_.name + "/" + sampler.name))
        add(std::make_unique<Contender>(sampler), *frame_, false);
    }
    std::unique_ptr<Frame> exact_frame;
    if (settings.flag("reference")) {
      exact_frame = scene_->frame(exact_settings_at(experiment_.frames.still), experiment_.image);
      SamplerChoice ceiling = references_.colors.sampler;
      ceiling.name = reference_name;
      add(std::make_unique<Contender>(ceiling), *exact_frame, true);
    }
    const auto rows = measure_speed(choice_.name, timed, settings, experiment_.seed, workers_,
                                    [&](double share) { progress_.advance(share); });
    results_.rows.insert(results_.rows.end(), rows.begin(), rows.end());
  }

  const Experiment& experiment_;
  const SceneChoice& choice_;
  const Catalog& catalog_;
  Shared& shared_;
  const Workers& workers_;
  Sink& sink_;
  Progress& progress_;
  ContentHashes& hashes_;
  Results& results_;

  References references_;
  const Scene* scene_ = nullptr;
  std::unique_ptr<Frame> frame_;
  Reference reference_;
  std::vector<MergedBlock> column_blocks_, pixel_blocks_;
  std::vector<double> error_sum_;
};

}  // namespace

// The reference, the contenders, the passes over frames, and timing if it is asked for.
std::size_t steps_on(const SceneChoice& scene, const Experiment& experiment) {
  std::size_t timings = 0;
  for (const PassChoice& metric : experiment.metrics) timings += registered_metric(metric.name).is_timing();
  return 1 + samplers_on(scene, experiment).size() + has_frame_passes(experiment) + timings;
}

void run_scene(const SceneChoice& scene, const SceneContext& context, Results& results) {
  SceneRun(scene, context, results).run();
}

}  // namespace moire
