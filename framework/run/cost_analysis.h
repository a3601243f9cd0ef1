// The cost model of a run, with what can be read off from it.
#pragma once

#include <set>
#include <string>

#include <moire/settings.h>

#include "run/results.h"

namespace moire {

// Adds an Analysis and its rows to `results`, made from the rows of coverage and speed; what stands in the way becomes
// a Failure. `on_lines`: the contenders that find runs of lines; the others' hits are points'.
void analyse_cost(const Settings& settings, const std::set<std::string>& on_lines, Results& results);

}  // namespace moire
