// Faces from the corners that files and built-in worlds give.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "world/world.h"

namespace shadow_planes {

// What keeps these corners from being a face, as a phrase `is ... (found); what would be right`; empty: nothing. A
// polygon without area is a face, without parts.
std::string problem_of(std::span<const Vector> corners);

// The plane's normal points to the side from which the corners go round counterclockwise; concave polygons become
// several parts. Requires: problem_of() finds nothing.
Face face_of(std::span<const Vector> corners);

// The middle of a face's area. Requires: it has parts.
Vector middle_of(const std::vector<Convex>& parts);

// Gives faces in one plane that plane to the bit, or its reverse, so that no rounding decides which of them is nearer.
void share_planes(std::vector<Face>& faces);

}  // namespace shadow_planes
