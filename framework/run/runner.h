// Runs an experiment: every contender on every scene, judged, then timed.
#pragma once

#include <string>
#include <vector>

#include "config/experiment.h"
#include "run/results.h"
#include "run/sink.h"
#include "run/workers.h"

namespace moire {

// Failures of plugins become Failure entries, and the run goes on; Ctrl-C leaves `interrupted` set and what is
// finished. Error: the sink cannot write.
Results run_experiment(const Experiment& experiment, const Catalog& catalog, const Workers& workers, Sink& sink,
                       std::vector<std::string> command);

}  // namespace moire
