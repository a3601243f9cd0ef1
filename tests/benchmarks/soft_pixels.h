// Benchmark of exact soft shadows: exact averages of pixels against averages of hard shadows.
#pragma once

namespace moire::benchmark {

void run_soft_pixels();

}  // namespace moire::benchmark
