// Polygons cut by planes and lines: convex ones of points, of directions, of the image.
#pragma once

#include <vector>

#include <moire/geometry.h>

#include "world/space.h"

namespace shadow_planes {

// A share of the way from p to q.
inline Vector between(const Vector& p, const Vector& q, double share) { return p + share * (q - p); }
inline moire::Point between(const moire::Point& p, const moire::Point& q, double share) {
  return {p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)};
}
inline moire::Pole between(const moire::Pole& p, const moire::Pole& q, double share) {
  return {p.x + share * (q.x - p.x), p.y + share * (q.y - p.y), p.w + share * (q.w - p.w)};
}

namespace detail {

// Calls point(p, value) for each corner, and cut(p) where an edge passes through 0. Both polygons on an edge find the
// same point there: it is sought from the positive end.
template <class P, class Value, class OnPoint, class OnCut>
void walk(const std::vector<P>& polygon, Value value, OnPoint point, OnCut cut) {
  if (polygon.empty()) return;
  const P* from = &polygon.back();
  double before = value(*from);
  for (const P& to : polygon) {
    const double after = value(to);
    if (before < 0 && after > 0) {
      cut(between(to, *from, after / (after - before)));
    } else if (before > 0 && after < 0) {
      cut(between(*from, to, before / (before - after)));
    }
    point(to, after);
    from = &to;
    before = after;
  }
}

}  // namespace detail

// Replaces `inside` by the part of the polygon where value(point), linear, is not negative.
template <class P, class Value>
void keep(const std::vector<P>& polygon, Value value, std::vector<P>& inside) {
  inside.clear();
  detail::walk(
      polygon, value,
      [&](const P& p, double v) {
        if (v >= 0) inside.push_back(p);
      },
      [&](const P& p) { inside.push_back(p); });
}

// Also replaces `outside` by the part where it is not positive; both have the same points on the cut.
template <class P, class Value>
void split(const std::vector<P>& polygon, Value value, std::vector<P>& inside, std::vector<P>& outside) {
  inside.clear();
  outside.clear();
  detail::walk(
      polygon, value,
      [&](const P& p, double v) {
        if (v >= 0) inside.push_back(p);
        if (v <= 0) outside.push_back(p);
      },
      [&](const P& p) {
        inside.push_back(p);
        outside.push_back(p);
      });
}

}  // namespace shadow_planes
