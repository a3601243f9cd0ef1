// What the experiments of these tests may speak of: a few plugins in memory, metrics and lookups.
#pragma once

#include "config/experiment.h"

namespace moire::test {

// Scenes cartoon, heightfield, textured_plane; samplers area, bilinear, jittered (which alone takes filters), point,
// supersample; metrics coverage, error, speed; lookups nearest, linear_across, bilinear, mipmap; filters box, tent,
// mitchell.
const Vocabulary& vocabulary();

}  // namespace moire::test
