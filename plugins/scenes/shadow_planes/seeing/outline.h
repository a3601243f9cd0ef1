// Convex polygons of the image and their edges.
#pragma once

#include <algorithm>
#include <vector>

#include <moire/geometry.h>

namespace shadow_planes {

// Convex, clockwise as seen on the screen: its area is positive in coordinates whose y grows downward.
using Outline = std::vector<moire::Point>;

// a x + b y + c w; above 0 on one side.
struct Line {
  double a = 0, b = 0, c = 0;

  double operator()(const moire::Point& p) const { return a * p.x + b * p.y + c; }
  double operator()(const moire::Pole& p) const { return a * p.x + b * p.y + c * p.w; }
};

// Above 0 within an outline that has this edge.
inline Line edge_line(moire::Point p, moire::Point q) {
  return {p.y - q.y, q.x - p.x, p.x * (q.y - p.y) - p.y * (q.x - p.x)};
}

// Twice the area, in a shape whose far corners do not cost digits.
inline double doubled_area(const Outline& outline) {
  double sum = 0;
  for (std::size_t k = 2; k < outline.size(); ++k) {
    const moire::Point &o = outline[0], &p = outline[k - 1], &q = outline[k];
    sum += (p.x - o.x) * (q.y - o.y) - (q.x - o.x) * (p.y - o.y);
  }
  return sum;
}

inline moire::Rectangle box_of(const Outline& outline) {
  moire::Rectangle box{outline[0].x, outline[0].y, outline[0].x, outline[0].y};
  for (const moire::Point& p : outline) {
    box.x0 = std::min(box.x0, p.x), box.x1 = std::max(box.x1, p.x);
    box.y0 = std::min(box.y0, p.y), box.y1 = std::max(box.y1, p.y);
  }
  return box;
}

inline bool touch(const moire::Rectangle& p, const moire::Rectangle& q) {
  return p.x0 <= q.x1 && q.x0 <= p.x1 && p.y0 <= q.y1 && q.y0 <= p.y1;
}

}  // namespace shadow_planes
