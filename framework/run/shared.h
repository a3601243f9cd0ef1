// What one scene entry of an experiment can take over from the one before it: the scene itself where only per-frame
// settings differ, and the reference where all that it depends on is the same.
#pragma once

#include <memory>

#include "run/reference_store.h"

namespace moire {

class Shared {
 public:
  // `store`: of references that outlive the run.
  explicit Shared(const ReferenceStore& store) : store_(store) {}

  // The entry's scene. Error: what its plugin throws.
  const Scene& scene(const SceneChoice& choice);

  // The reference of a frame of the scene that was asked for last.
  const Reference& reference(const ReferenceRequest& request, ContentHashes& hashes, const Workers& workers);

 private:
  const ReferenceStore& store_;
  const Plugin* plugin_ = nullptr;
  Settings settings_;  // without what may differ from frame to frame
  std::unique_ptr<Scene> scene_;
  std::string reference_name_;
  Settings exact_;
  Reference reference_;
};

}  // namespace moire
