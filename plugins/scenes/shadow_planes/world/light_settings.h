// From the scene's settings to its light.
#pragma once

#include <string>

#include <moire/settings.h>

#include "world/source.h"

namespace shadow_planes {

LightKind light_kind_of(const moire::Settings& settings);

// What a light of the kind asked for lacks, as `has no ... (...); ...`; empty: nothing.
std::string problem_of(const LightShape& shape, LightKind kind);

// Requires: problem_of() finds nothing.
Light light_of(const LightShape& shape, const moire::Settings& settings);

}  // namespace shadow_planes
