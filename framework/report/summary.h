// The main numbers of a run as plain text, for the end of `moire run`.
#pragma once

#include <string>

#include "run/results.h"

namespace moire::report {

// A table a scene: contenders by the metrics that are the main ones of their pass, then failures with their reasons.
std::string summary_text(const Results& results);

}  // namespace moire::report
