// Where on a receiver irradiance is not smooth.
//
// The shape of what is seen of the light changes where a point of the receiver is in one plane with (1) a corner of the
// light and an edge of a caster, (2) a corner of a caster and an edge of the light, (3) a corner of one caster and an
// edge of another, (4) a whole caster, or (5) the light; all of these are straight. Where it changes as two edges of
// casters cross behind an edge of the light or of a third caster, the line is curved: those are not found here.
#pragma once

#include <vector>

#include "light/illumination.h"

namespace shadow_planes {

// A segment of the receiver; an end with w = 0 is infinitely far in that direction.
struct CriticalLine {
  Homogeneous from, to;
};

std::vector<CriticalLine> critical_lines(const World& world, const Illumination& illumination);

// Corners of casters that stand on the receiver: around them irradiance depends on the direction.
std::vector<Vector> contacts(const Illumination& illumination);

}  // namespace shadow_planes
