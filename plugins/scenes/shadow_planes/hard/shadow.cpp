#include "hard/shadow.h"

#include <algorithm>

#include "world/cut.h"

namespace shadow_planes {

const std::vector<Homogeneous>& ShadowProjector::operator()(const Convex& occluder, const Plane& receiver,
                                                            const Homogeneous& light) {
  const double top = receiver.of(light);  // L.G
  shadow_.clear();
  corners_.clear();
  for (const Vector& p : occluder) corners_.push_back({p, receiver.distance(p)});
  if (clip_ == Clip::both) {
    keep(
        corners_, [](const Corner& c) { return c.height; }, cut_);
    if (light.w > 0) {
      keep(
          cut_, [top](const Corner& c) { return top - c.height; }, corners_);
    } else {
      std::swap(corners_, cut_);
    }
    if (corners_.size() < 3) return shadow_;
  }
  for (const Corner& corner : corners_) {
    double height = corner.height;
    // What rounding put beyond the cuts is on them.
    if (clip_ == Clip::both) height = std::max(0.0, light.w > 0 ? std::min(height, top) : height);
    const Vector s = top * corner.p - height * Vector{light.x, light.y, light.z};
    const double w = top - light.w * height;
    if (clip_ == Clip::both) {
      shadow_.push_back({s.x, s.y, s.z, w});
    } else if (w != 0) {
      shadow_.push_back({s.x / w, s.y / w, s.z / w, 1});
    } else {
      shadow_.clear();
      return shadow_;
    }
  }
  return shadow_;
}

}  // namespace shadow_planes
