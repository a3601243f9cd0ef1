// The settings under which a scene is exact: references are rendered with them.
#pragma once

#include <string>

#include <moire/plugin.h>

namespace moire {

// The scene's settings, with those under which it is exact.
Settings exact_settings(const ScenePlugin& scene, Settings settings);

// "walk=grid, levels=none": what exact_settings changes in these.
std::string exact_note(const ScenePlugin& scene, const Settings& settings);

}  // namespace moire
