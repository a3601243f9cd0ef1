#include "run/shared.h"

namespace moire {

namespace {

Settings without_per_frame(const Plugin& plugin, Settings settings) {
  const Settings defaults(plugin.parameters());
  for (const Parameter& parameter : plugin.parameters()) {
    if (parameter.is_per_frame) settings.set(parameter.name, defaults.values().find(parameter.name)->second);
  }
  return settings;
}

}  // namespace

const Scene& Shared::scene(const SceneChoice& choice) {
  Settings settings = without_per_frame(*choice.plugin, choice.settings);
  if (scene_ && plugin_ == choice.plugin && settings_ == settings) return *scene_;
  reference_name_.clear();
  scene_.reset();  // before the next one, so that only one is held
  scene_ = choice.plugin->scene->make(choice.settings);
  plugin_ = choice.plugin;
  settings_ = std::move(settings);
  return *scene_;
}

const Reference& Shared::reference(const ReferenceChoice& choice, const std::string& scene_note, const Settings& exact,
                                   ImageSize image, int frame_number, std::uint64_t seed, const Workers& workers) {
  if (reference_name_ == choice.sampler.name && exact_ == exact) return reference_;
  reference_name_.clear();
  const auto frame = scene_->frame(exact, image);
  reference_ = make_reference(choice, scene_note, *frame, frame_number, seed, workers);
  reference_name_ = choice.sampler.name;
  exact_ = exact;
  return reference_;
}

}  // namespace moire
