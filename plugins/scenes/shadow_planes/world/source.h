// What a scene is made from: its faces, and a light of each kind that it can have.
#pragma once

#include <optional>
#include <vector>

#include "world/world.h"

namespace shadow_planes {

struct LightShape {
  std::vector<Vector>
      corners;               // of an area light; counterclockwise on the side that it sends light to; none: not given
  std::optional<Vector> at;  // of a point light; none: the middle of the area
  std::optional<Vector> towards;  // of a directional one, the way to it, of any length; none: the way from the origin
                                  // to the point
  moire::Color color{1, 1, 1};
};

struct Source {
  std::vector<Face> faces;
  LightShape light;
};

}  // namespace shadow_planes
