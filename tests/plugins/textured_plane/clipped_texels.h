// What a pixel sees of the plane by the slow way: the square of every texel is projected into the picture, corner by
// corner, and clipped to the pixel. Rays and corners are of extended precision.
#pragma once

#include <map>

#include "plugins/textured_plane/views.h"

namespace moire::test {

struct Direction3 {
  long double x, y, z;
};

// From the camera through an image point: east, south, up. Of no particular length.
Direction3 ray_through(const Camera& camera, long double x, long double y);

// How far ahead of the camera a ray meets the plane, along the plane in the direction of view.
long double distance_ahead(const Camera& camera, const Direction3& ray);

struct Clipped {
  std::map<Element, double> weights;  // of texels, far ground and sky
  double r = 0, g = 0, b = 0;         // of the texels alone
};

Clipped clipped(const Camera& camera, const Texels& texels, int x, int y);

}  // namespace moire::test
