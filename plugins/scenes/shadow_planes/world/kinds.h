// Built-in worlds.
#pragma once

#include <string_view>

#include "world/source.h"

namespace shadow_planes {

inline constexpr std::string_view kinds = "room tilted parallel three wall slats";

// All but the room: a floor of 6 x 6 units and, 4 above its middle, a light of 1 x 1 turned by 17 degrees; between
// them a tilted quadrilateral, one parallel to the light with edges along the light's, three disjoint ones, a wall that
// stands on the floor with two that overlap seen from the light, or eight slats.
// Requires: one of `kinds`.
Source kind_of_name(std::string_view name);

}  // namespace shadow_planes
