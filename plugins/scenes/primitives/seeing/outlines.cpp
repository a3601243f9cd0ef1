// A chord polygon of n corners has the area of its circle if they lie at radius * sqrt(a / sin a), a = 2 pi / n. Then
// its corners are radius a^2 / 12 outside of the circle and the middles of its chords half as far inside, to the
// leading order.
#include "outlines.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace primitives {

namespace {

using moire::Point;

constexpr double pi = std::numbers::pi;

// An arc about `center`, `count` chords of the angle `step`.
struct Arc {
  Point center;
  double radius;  // of the corners; those at either end of the arc lie at `end_radius`
  double end_radius;
  double start, step;  // radians
  std::int64_t count;

  Point corner(std::int64_t k) const {
    const double angle = start + step * static_cast<double>(k), r = k == 0 || k == count ? end_radius : radius;
    return {center.x + r * std::cos(angle), center.y + r * std::sin(angle)};
  }
};

// So many that chords are within the tolerance of a circle, and those of half a circle whose ends stay on it, too:
// there are 4 at least, and their other corners are 4/3 as far outside at most; 9/8 covers what the leading order
// leaves out.
std::int64_t chords(double radius, double angle, double tolerance) {
  const double step = std::sqrt(8 * tolerance / radius);
  return std::max<std::int64_t>(static_cast<std::int64_t>(std::ceil(angle / step)), angle > pi ? 8 : 4);
}

// Appends the corners after the first, and leaves out those of parts that do not come near the window.
void append(const Arc& arc, std::int64_t first, std::int64_t last, const moire::Rectangle& window,
            std::vector<Point>& points) {
  const Point q = arc.corner(last);
  if (last - first > 1) {
    // The part, and a chord over it, is within a disk about its middle.
    const std::int64_t middle = first + (last - first) / 2;
    const Point p = arc.corner(first), m = arc.corner(middle);
    const double reach = 1 + std::max(std::hypot(p.x - m.x, p.y - m.y), std::hypot(q.x - m.x, q.y - m.y));
    const double dx = std::max({window.x0 - m.x, m.x - window.x1, 0.0});
    const double dy = std::max({window.y0 - m.y, m.y - window.y1, 0.0});
    if (std::hypot(dx, dy) <= reach) {
      append(arc, first, middle, window, points);
      append(arc, middle, last, window, points);
      return;
    }
  }
  points.push_back(q);
}

void add_circle(Point center, double radius, const moire::Rectangle& window, double tolerance, Outline& out) {
  const std::int64_t count = chords(radius, 2 * pi, tolerance);
  const double step = 2 * pi / static_cast<double>(count), corners = radius * std::sqrt(step / std::sin(step));
  const std::size_t first = out.points.size();
  append({center, corners, corners, 0, step, count}, 0, count, window, out.points);
  if (out.points.size() < first + 3) {
    out.points.resize(first);  // far from the window
  } else {
    out.contours.push_back(static_cast<std::uint32_t>(first));
  }
}

// Half a disk behind the axis' end, from one side of the bar to the other. Its ends stay on the sides; with the other
// corners at q times the radius its area is half a disk's where (n - 2) q^2 + 2 q = pi / sin(pi / n).
void add_cap(Point center, double radius, double start, const moire::Rectangle& window, double tolerance,
             std::vector<Point>& points) {
  const std::int64_t count = chords(radius, pi, tolerance);
  const auto n = static_cast<double>(count);
  const double q = (std::sqrt(1 + (n - 2) * pi / std::sin(pi / n)) - 1) / (n - 2);
  append({center, q * radius, radius, start, pi / n, count}, 0, count, window, points);
}

void add_bar(const Bar& bar, const moire::Rectangle& window, double tolerance, Outline& out) {
  const Point p = bar.from(), q = bar.to(), side = bar.across();
  out.contours.push_back(static_cast<std::uint32_t>(out.points.size()));
  out.points.push_back({p.x + side.x, p.y + side.y});
  if (bar.is_round()) add_cap(p, bar.half_width(), std::atan2(side.y, side.x), window, tolerance, out.points);
  if (!bar.is_round()) out.points.push_back({p.x - side.x, p.y - side.y});
  out.points.push_back({q.x - side.x, q.y - side.y});
  if (bar.is_round()) add_cap(q, bar.half_width(), std::atan2(-side.y, -side.x), window, tolerance, out.points);
  if (!bar.is_round()) out.points.push_back({q.x + side.x, q.y + side.y});
}

}  // namespace

void outline_of(const Shape& shape, const moire::Rectangle& window, double tolerance, Outline& out) {
  out.points.clear();
  out.contours.clear();
  if (const Bar* const bar = std::get_if<Bar>(&shape)) {
    add_bar(*bar, window, tolerance, out);
    return;
  }
  const Ring& ring = *std::get_if<Ring>(&shape);
  add_circle(ring.center, ring.outer, window, tolerance, out);
  if (ring.inner > 0) add_circle(ring.center, ring.inner, window, tolerance, out);
}

}  // namespace primitives
