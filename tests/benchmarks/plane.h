// What exact averages of the textured plane cost.
#pragma once

#include "loading/catalog.h"

namespace moire::benchmark {

void textured_plane(const Catalog& catalog);

}  // namespace moire::benchmark
