// What the exact picture of the terrain costs.
#pragma once

#include "loading/catalog.h"

namespace moire::benchmark {

void terrain_truth(const Catalog& catalog);

}  // namespace moire::benchmark
