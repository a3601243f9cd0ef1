// The hard shadow of a convex polygon on a plane, after Blinn 1988 (doi:10.1109/38.7759).
#pragma once

#include <vector>

#include "world/world.h"

namespace shadow_planes {

// Which points of an occluder are projected.
enum class Clip {
  both,  // those between receiver and light, which are those that cast a shadow
  none,  // all, as published: what lies behind the receiver or beyond the light gives false shadows
};

// The shadow S = (L.G) P - (P.G) L of every point P of an occluder, before division by w: a convex polygon of points
// of the plane, of which those with w = 0 are infinitely far. With Clip::none each corner is divided by its w, whatever
// that is; the polygon may cross itself then, and a corner without a shadow point leaves none. Empty: no shadow.
class ShadowProjector {
 public:
  explicit ShadowProjector(Clip clip) : clip_(clip) {}

  // Requires: L.G > 0. The result is valid until the next call.
  const std::vector<Homogeneous>& operator()(const Convex& occluder, const Plane& receiver, const Homogeneous& light);

 private:
  struct Corner {
    Vector p;
    double height;  // P.G
  };
  friend Corner between(const Corner& a, const Corner& b, double share) {
    return {a.p + share * (b.p - a.p), a.height + share * (b.height - a.height)};
  }

  Clip clip_;
  std::vector<Corner> corners_, cut_;
  std::vector<Homogeneous> shadow_;
};

}  // namespace shadow_planes
