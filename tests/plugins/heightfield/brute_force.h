// What a ray sees of a map of boxes, found without any walk: the ray is cut with every box within the far limit. Shares
// no code with the scene. It must never guess: where moving the boxes' faces by 1e-9 of a voxel changes what is seen,
// it names every element that may be.
#pragma once

#include <vector>

#include "plugins/heightfield/small_terrain.h"

namespace moire::test {

struct Ray {
  double x, y, z;  // in world units; east, south, up
};

// Through an image point: a pinhole turned up by the pitch, then about the vertical by the yaw.
Ray ray_through(const View& view, double image_x, double image_y);

// The image point that a direction in front of the camera passes through.
Point image_of(const View& view, Ray direction);

// What a brute force says of one ray.
using SeenBy = std::vector<Element>(const Map&, const View&, Ray);

// The elements that a ray may see, `background` for the sky. One unless the ray meets an edge within 1e-9.
std::vector<Element> seen_by(const Map& map, const View& view, Ray ray);

// The same where a voxel is not a box but a wall as high, standing where the ray enters it: the eye's own stands at the
// eye.
std::vector<Element> wall_seen_by(const Map& map, const View& view, Ray ray);

// What seen_by says, for a walk that looks at one voxel a step along the axis on which the ray advances more voxels
// (columns where it advances as many): the voxel under the middle of the step, or under the eye where that lies ahead
// of it.
std::vector<Element> seen_by_major_steps(const Map& map, const View& view, Ray ray);

}  // namespace moire::test
