// Exact averages of the scene `pattern`, beside points.
#pragma once

#include "loading/catalog.h"

namespace moire::benchmark {

void run_patterns(const Catalog& catalog);

}  // namespace moire::benchmark
