// A pinhole camera.
#pragma once

#include <moire/geometry.h>

#include "world/space.h"

namespace shadow_planes {

// Looks from `eye` along `ahead`; right, down and ahead are of length 1 and at right angles.
struct Camera {
  moire::ImageSize size;
  Vector eye, right{1, 0, 0}, down{0, 1, 0}, ahead{0, 0, -1};
  double focal = 1;  // pixels

  // From the eye through a point of the image; its part along `ahead` is 1.
  Vector ray(moire::Point p) const {
    return ahead + ((p.x - 0.5 * size.width) / focal) * right + ((p.y - 0.5 * size.height) / focal) * down;
  }
  // Where a point is seen, as (x, y, w): at (x / w, y / w) if w, how far ahead it is, is above 0.
  moire::Pole image_of(const Homogeneous& p) const {
    const Vector from_eye = Vector{p.x, p.y, p.z} - p.w * eye;
    const double depth = dot(from_eye, ahead);
    return {focal * dot(from_eye, right) + 0.5 * size.width * depth,
            focal * dot(from_eye, down) + 0.5 * size.height * depth, depth};
  }
};

}  // namespace shadow_planes
