// An experiment's JSON with nothing left to look up: shorthand written out, --set applied, used files merged in.
#pragma once

#include <span>
#include <string>

#include "config/json_files.h"

namespace moire {

// The root is an object, or there are problems. Its "scenes", "samplers" and "metrics" are lists if they are anything
// sensible; names in them, and as "reference", have become objects with a "type". Error: a syntax error.
JsonNode read_experiment_tree(const ExperimentPlace& place, std::span<const std::string> sets, Problems& problems);

}  // namespace moire
