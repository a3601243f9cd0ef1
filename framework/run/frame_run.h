// Runs the passes over frames: all contenders of a scene, frame after frame, keeping no frame longer than it is looked
// at.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "metrics/temporal_metric.h"
#include "pictures/picture_pass.h"
#include "run/contender.h"
#include "run/reference.h"

namespace moire {

// A contender's passes: the same ones, in the same order, for every contender.
struct Watched {
  std::string name;
  std::unique_ptr<Contender> contender;            // null: the reference
  std::vector<std::unique_ptr<FramePass>> passes;  // null where a pass is not run on the reference
  std::string failure;                             // why it was given up; empty: it was not
};

// What frames are made of.
struct FrameSource {
  const Scene& scene;
  std::function<Settings(int frame)> settings, exact_settings;
  ImageSize image;
  int count, still;
  std::uint64_t seed;
};

// Shows every pass of every watched contender what it needs. `references`: judge all; what they throw ends the run
// as an Error that names the frame, what a contender throws becomes its `failure` and the others go on. `advance` is
// told the share that is done.
void run_frames(const FrameSource& source, const References& references, std::vector<Watched>& watched,
                const Workers& workers, const std::function<void(double)>& advance);

}  // namespace moire
