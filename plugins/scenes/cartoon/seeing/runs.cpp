#include "runs.h"

#include <algorithm>
#include <cmath>

#include "stack.h"

namespace cartoon {

namespace {

using moire::Point;

bool comes_before(Point p, Point q) { return p.x != q.x ? p.x < q.x : p.y < q.y; }

}  // namespace

void LineCutter::meet_upright(double x, double y, double direction) {
  edges_.in_column(edges_.column_of(x), [&](const Edge& edge) {
    if (edge.meets(x)) meetings_.push_back({(edge.y_at(x) - y) * direction, edge.layer, edge.turn, edge.inside});
  });
}

// All edges of the drawing are looked at.
void LineCutter::meet_slanted(Point from, Point to) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const double ux = (to.x - from.x) / length, uy = (to.y - from.y) / length;
  for (std::size_t k = 0; k < outlines_.layers(); ++k) {
    const moire::Polygon polygon = outlines_.polygon(k, points_);
    for (std::size_t c = 0; c < polygon.contours.size(); ++c) {
      const std::size_t first = polygon.contours[c];
      const std::size_t end = c + 1 < polygon.contours.size() ? polygon.contours[c + 1] : polygon.points.size();
      const auto aside = [&](Point p) { return (p.x - from.x) * uy - (p.y - from.y) * ux; };
      Point p = polygon.points[end - 1];
      double p_aside = aside(p);
      for (std::size_t i = first; i < end; ++i) {
        const Point q = polygon.points[i];
        const double q_aside = aside(q);
        if ((p_aside < 0) != (q_aside < 0)) {
          // From the same end whichever way the contour goes, so that shared edges are met at the same place.
          const bool forward = comes_before(p, q);
          const Point a = forward ? p : q, b = forward ? q : p;
          const double a_aside = forward ? p_aside : q_aside, b_aside = forward ? q_aside : p_aside;
          const double part = a_aside / (a_aside - b_aside);
          const double a_at = (a.x - from.x) * ux + (a.y - from.y) * uy;
          const double b_at = (b.x - from.x) * ux + (b.y - from.y) * uy;
          meetings_.push_back({a_at + (b_at - a_at) * part, static_cast<std::uint32_t>(k),
                               static_cast<std::int16_t>(p_aside < 0 ? 1 : -1), inside_bits(polygon.rule)});
        }
        p = q;
        p_aside = q_aside;
      }
    }
  }
}

std::span<const LineRun> LineCutter::runs(Point from, Point to, double begin, double end) {
  meetings_.clear();
  if (from.x == to.x) {
    meet_upright(from.x, from.y, to.y < from.y ? -1 : 1);
  } else {
    meet_slanted(from, to);
  }
  // What lies before the beginning counts in any order.
  const auto ahead =
      std::partition(meetings_.begin(), meetings_.end(), [&](const Meeting& m) { return m.at <= begin; });
  std::sort(ahead, meetings_.end(), [](const Meeting& p, const Meeting& q) { return p.at < q.at; });

  thread_local Stack stack;  // clear between calls
  stack.reserve(outlines_.layers());
  runs_.clear();
  const auto turn = [](const Meeting& m) { stack.turn(m.layer, m.turn, m.inside); };
  std::for_each(meetings_.begin(), ahead, turn);
  double at = begin;
  std::uint32_t top = stack.top();
  for (auto next = ahead; next != meetings_.end() && next->at < end;) {
    const double here = next->at;
    for (; next != meetings_.end() && next->at == here; ++next) turn(*next);
    const std::uint32_t now = stack.top();
    if (now == top) continue;
    runs_.push_back({at, here, top});
    at = here;
    top = now;
  }
  runs_.push_back({at, end, top});
  for (const Meeting& m : meetings_) stack.clear(m.layer);
  return runs_;
}

}  // namespace cartoon
