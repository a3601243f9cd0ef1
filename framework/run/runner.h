// Runs an experiment: every contender on every scene, judged, then timed.
#pragma once

#include <string>
#include <vector>

#include "config/experiment.h"
#include "run/reference_store.h"
#include "run/results.h"
#include "run/sink.h"
#include "run/workers.h"

namespace moire {

// Failures of plugins become Failure entries, and the run goes on; Ctrl-C leaves `interrupted` set and what is
// finished. `store`: references of earlier runs. Error: the sink cannot write.
Results run_experiment(const Experiment& experiment, const Catalog& catalog, const Workers& workers, Sink& sink,
                       const ReferenceStore& store, std::vector<std::string> command);

}  // namespace moire
