// Views of small maps that leave nothing out: directions all round, steep and flat, and the awkward cases by name.
#pragma once

#include <vector>

#include "plugins/heightfield/small_terrain.h"

namespace moire::test {

// The map that most views look at: rough, so that much is hidden.
inline constexpr int usual_columns = 16, usual_rows = 12;
inline constexpr double usual_relief = 8;
Map usual_map();

// From above the summits: seven pitches, nine yaws, and in turn four fields of view, six eyes and odd and even sizes.
std::vector<View> views_all_round();

// From between the hills, within the ground, on grid lines and vertices, far off, straight down, far limits short and
// long.
std::vector<View> awkward_views(const Map& map);

// All of these.
std::vector<View> all_views(const Map& map);

}  // namespace moire::test
