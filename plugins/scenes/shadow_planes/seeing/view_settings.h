// From the scene's settings to its camera.
#pragma once

#include <moire/settings.h>

#include "seeing/camera.h"

namespace shadow_planes {

Camera camera_of(const moire::Settings& settings, moire::ImageSize size);

}  // namespace shadow_planes
