// Soft shadows of the scene `shadow_planes`: hard ones averaged on maps, beside rays.
#pragma once

#include "loading/catalog.h"

namespace moire::benchmark {

void run_shadows(const Catalog& catalog);

}  // namespace moire::benchmark
