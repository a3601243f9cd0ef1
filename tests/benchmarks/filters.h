// Benchmarks of filters: what each costs over the box, on the same points.
#pragma once

#include "loading/catalog.h"

namespace moire::benchmark {

void run_filters(const Catalog& catalog);

}  // namespace moire::benchmark
