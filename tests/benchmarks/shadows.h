// Soft shadows of the scene `shadow_planes`: hard ones averaged on maps, beside rays.
#pragma once

#include <cstddef>
#include <vector>

#include <moire/geometry.h>

#include "loading/catalog.h"

namespace moire::benchmark {

// Points of a light: the lattice of the R2 sequence (Roberts 2018).
std::vector<LightPoint> lattice(std::size_t count);

void run_shadows(const Catalog& catalog);

}  // namespace moire::benchmark
