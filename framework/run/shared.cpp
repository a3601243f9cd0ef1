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

const Reference& Shared::reference(const ReferenceRequest& request, ContentHashes& hashes, const Workers& workers) {
  if (reference_name_ == request.choice.sampler.name && exact_ == request.scene.settings) {
    reference_.recipe = recipe_of(request);
    reference_.origin = "the same as above";
    return reference_;
  }
  reference_name_.clear();
  reference_ = store_.find_or_make(request, hashes, [&] {
    return make_reference(request, *scene_->frame(request.scene.settings, request.image), workers);
  });
  reference_name_ = request.choice.sampler.name;
  exact_ = request.scene.settings;
  return reference_;
}

}  // namespace moire
