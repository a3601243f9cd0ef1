// Polygons in homogeneous coordinates, cut to a convex outline; divided last.
#pragma once

#include <vector>

#include "seeing/outline.h"
#include "world/cut.h"

namespace shadow_planes {

// Points with w = 0 are infinitely far, those with w < 0 behind the eye: neither is within the outline, so that what is
// left has w > 0, but for points of no direction at all, which are dropped.
class ClipTo {
 public:
  // The result is valid until the next call.
  const Outline& operator()(const std::vector<moire::Pole>& polygon, const Outline& outline) {
    result_.clear();
    rest_ = polygon;
    const moire::Point* from = &outline.back();
    for (const moire::Point& to : outline) {
      keep(rest_, edge_line(*from, to), cut_);
      std::swap(rest_, cut_);
      if (rest_.size() < 3) return result_;
      from = &to;
    }
    for (const moire::Pole& p : rest_) {
      if (p.w > 0) result_.push_back({p.x / p.w, p.y / p.w});
    }
    return result_;
  }

 private:
  std::vector<moire::Pole> rest_, cut_;
  Outline result_;
};

}  // namespace shadow_planes
