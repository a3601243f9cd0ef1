// The cost model of a run, with what can be read off from it.
#pragma once

#include <moire/settings.h>

#include "run/results.h"

namespace moire {

// Adds an Analysis and its rows to `results`, made from the rows of coverage and speed; what stands in the way becomes
// a Failure.
void analyse_cost(const Settings& settings, Results& results);

}  // namespace moire
