// Benchmarks of the exact integrators on drawings, beside Cairo and AGG in one process.
#pragma once

#include "loading/catalog.h"

namespace moire::benchmark {

// Requires: MOIRE_DATA is set.
void run_drawings(const Catalog& catalog);

}  // namespace moire::benchmark
