// A scene of an experiment: what it is judged against, and the jobs on it.
#pragma once

#include <cstddef>

#include "run/content.h"
#include "run/progress.h"
#include "run/shared.h"
#include "run/sink.h"
#include "run/workers.h"

namespace moire {

// What a scene's run works with.
struct SceneContext {
  const Experiment& experiment;
  const Catalog& catalog;
  Shared& shared;
  const Workers& workers;
  Sink& sink;
  Progress& progress;
  ContentHashes& hashes;
};

// Steps of progress that a scene takes.
std::size_t steps_on(const SceneChoice& scene, const Experiment& experiment);

// Runs all contenders and passes on a scene, whose entry is the last of results.scenes. What fails is noted there and
// the rest goes on. Throws Interrupted alone.
void run_scene(const SceneChoice& scene, const SceneContext& context, Results& results);

}  // namespace moire
