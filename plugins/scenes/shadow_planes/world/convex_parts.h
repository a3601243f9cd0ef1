// Simple polygons of the plane as convex parts: ears cut off (Meisters 1975), then joined again where the whole stays
// convex (Hertel and Mehlhorn 1983, doi:10.1007/3-540-12689-9_105): at most four times the fewest.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <moire/geometry.h>

namespace shadow_planes {

// Two sides that cross, by their first corners. Sides that only touch do not.
std::optional<std::pair<std::size_t, std::size_t>> first_crossing(std::span<const moire::Point> polygon);

// Corners of each part, counterclockwise. Corners between two sides of one line are left out where all is convex.
// Requires: a simple polygon, counterclockwise in coordinates whose y grows upward.
std::vector<std::vector<std::size_t>> convex_parts(std::span<const moire::Point> polygon);

}  // namespace shadow_planes
