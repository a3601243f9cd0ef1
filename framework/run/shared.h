// What one scene entry of an experiment can take over from the one before it: the scene itself where only per-frame
// settings differ, and the reference where all that it depends on is the same.
#pragma once

#include <memory>
#include <string>

#include "run/reference.h"

namespace moire {

class Shared {
 public:
  // The entry's scene. Error: what its plugin throws.
  const Scene& scene(const SceneChoice& choice);

  // The reference of a frame of scene(choice) with `exact` settings.
  const Reference& reference(const ReferenceChoice& choice, const std::string& scene_note, const Settings& exact,
                             ImageSize image, int frame_number, std::uint64_t seed, const Workers& workers);

 private:
  const Plugin* plugin_ = nullptr;
  Settings settings_;  // without what may differ from frame to frame
  std::unique_ptr<Scene> scene_;
  std::string reference_name_;
  Settings exact_;
  Reference reference_;
};

}  // namespace moire
