// Benchmarks of adaptive sampling: samples and time spent for an error, against jittered sampling.
#pragma once

#include "loading/catalog.h"

namespace moire::benchmark {

void run_adaptive(const Catalog& catalog);

}  // namespace moire::benchmark
