// Benchmarks of the texture lookups: how near they come to the exact picture of a plane, and what one costs.
#pragma once

namespace moire::benchmark {

// Requires: MOIRE_DATA is set.
void run_lookups();

}  // namespace moire::benchmark
