// The floor of all timings: a sampler that looks at nothing.
#pragma once

#include <memory>

#include <moire/sampler.h>

namespace moire {

// Deposits the background, black, once a pixel.
std::unique_ptr<Sampler> make_empty_sampler();

}  // namespace moire
