// Benchmarks of exact areas of lines and circles: their time against Cairo's, and both errors.
#pragma once

namespace moire::benchmark {

void run_curves_exact();

}  // namespace moire::benchmark
