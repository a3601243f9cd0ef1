// Scenes: made once from their settings, seen many times.
#pragma once

#include <memory>

#include <moire/frame.h>
#include <moire/settings.h>

namespace moire {

// Holds what is heavy; immutable and safe to use from many threads once made.
class Scene {
 public:
  virtual ~Scene() = default;

  // The scene as seen in an image of this size. `settings` has every parameter of the scene's table; only those
  // marked per_frame may differ from what the scene was made with. The scene outlives the frame.
  virtual std::unique_ptr<Frame> frame(const Settings& settings, ImageSize size) const = 0;
};

}  // namespace moire
