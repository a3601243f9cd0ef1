// Light and shadow of one sun, baked into the colours of a terrain.
#pragma once

#include "ground_cover.h"

namespace heightfield {

// Multiplies each voxel's albedo by the light that reaches it: sun on its slope where nothing stands in the way, and
// sky.
void shine(CoveredGround& ground);

}  // namespace heightfield
