// From the scene's settings to what a frame looks with.
#pragma once

#include <moire/settings.h>

#include "look.h"

namespace heightfield {

Camera camera_of(const moire::Settings& settings, moire::ImageSize size);
View view_of(const moire::Settings& settings, const Voxels& voxels, const Camera& camera);
Manner manner_of(const moire::Settings& settings);

}  // namespace heightfield
