// Scenes with soft shadows: a light 1 x 1, turned by 17 degrees, 4 above the middle of a receiver 6 x 6, which is face
// 0.
#pragma once

#include <string>
#include <vector>

#include "seeing/camera.h"
#include "world/world.h"

namespace shadow_planes::test {

// Of convex outlines, counterclockwise seen from where the normal points.
Face face_of(Convex outline);
Convex rectangle(Vector corner, Vector side, Vector other_side);

// The light alone. Its colour gives a white surface right under it a radiance of 1.
World lit_receiver();

struct SoftScene {
  std::string name;
  World world;
};
// One tilted quad; a quad parallel to the light; three disjoint quads; a standing wall and an overlapping pair; 8
// slats.
std::vector<SoftScene> soft_scenes();

// Looks straight down from 10 above the receiver, which fills the picture: every pixel sees an equal square of it.
Camera overhead(moire::ImageSize size);
// Sees the receiver at a grazing angle.
Camera grazing(moire::ImageSize size);

}  // namespace shadow_planes::test
