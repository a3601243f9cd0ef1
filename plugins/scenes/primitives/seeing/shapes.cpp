#include "shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace primitives {

namespace {

using moire::Point;

// Whether points of an edge belong to what lies on the other side of where (nx, ny), its normal, points to: whether
// that is right of the edge, or below a level one.
bool keeps_edge(double nx, double ny) { return nx < 0 || (nx == 0 && ny < 0); }

// Where value + t rate, linear along a ray, is between low and high. Requires: rate != 0.
Span between(double low, double high, double rate) {
  const double one = low / rate, other = high / rate;
  return {std::min(one, other), std::max(one, other)};
}

}  // namespace

bool Disk::contains(Point p) const {
  const double dx = p.x - center.x, dy = p.y - center.y;
  const double beyond = dx * dx + dy * dy - radius * radius;
  return beyond < 0 || (beyond == 0 && keeps_edge(dx, dy));
}

std::optional<Span> Disk::meet(const Ray& ray) const {
  const double cx = center.x - ray.origin.x, cy = center.y - ray.origin.y;
  const double middle = cx * ray.ex + cy * ray.ey, aside = std::abs(cx * ray.ey - cy * ray.ex);
  if (!(aside < radius)) return std::nullopt;
  const double half = std::sqrt((radius - aside) * (radius + aside));
  return Span{middle - half, middle + half};
}

Bar::Bar(Point from, Point to, double half_width, bool is_round)
    : from_(from), to_(to), dx_(to.x - from.x), dy_(to.y - from.y), half_width_(half_width), is_round_(is_round) {
  if (dx_ == 0 && dy_ == 0) dx_ = 1;
  side_ = half_width * std::hypot(dx_, dy_);
  has_begin_ = keeps_edge(-dx_, -dy_);
  has_low_side_ = keeps_edge(dy_, -dx_);
}

Point Bar::across() const {
  const double length = std::hypot(dx_, dy_);
  return {-dy_ / length * half_width_, dx_ / length * half_width_};
}

bool Bar::is_between_ends(Point p) const {
  const double begin = after_begin(p), end = after_end(p);
  return (begin > 0 || (begin == 0 && has_begin_)) && (end < 0 || (end == 0 && !has_begin_));
}

bool Bar::is_between_sides(Point p) const {
  const double at = aside(p);
  return (at > -side_ || (at == -side_ && has_low_side_)) && (at < side_ || (at == side_ && !has_low_side_));
}

bool Bar::contains(Point p) const {
  if (is_between_sides(p) && is_between_ends(p)) return true;
  return is_round_ && (Disk{from_, half_width_}.contains(p) || Disk{to_, half_width_}.contains(p));
}

std::optional<Span> Bar::meet_rectangle(const Ray& ray) const {
  const double along = dx_ * ray.ex + dy_ * ray.ey, across = dx_ * ray.ey - dy_ * ray.ex;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Span both{-infinity, infinity};
  if (along != 0) {
    both = between(-after_begin(ray.origin), -after_end(ray.origin), along);
  } else if (!is_between_ends(ray.origin)) {
    return std::nullopt;
  }
  if (across != 0) {
    const double here = aside(ray.origin);
    const Span sides = between(-side_ - here, side_ - here, across);
    both = {std::max(both.begin, sides.begin), std::min(both.end, sides.end)};
  } else if (!is_between_sides(ray.origin)) {
    return std::nullopt;
  }
  if (!(both.begin < both.end)) return std::nullopt;
  return both;
}

Spans Bar::meet(const Ray& ray) const {
  std::optional<Span> all = meet_rectangle(ray);
  if (is_round_) {
    // It is convex, so that its parts meet the ray without a gap.
    for (const Point end : {from_, to_}) {
      const auto span = Disk{end, half_width_}.meet(ray);
      if (!span) continue;
      all = all ? Span{std::min(all->begin, span->begin), std::max(all->end, span->end)} : *span;
    }
  }
  Spans spans;
  if (all) spans.add(*all);
  return spans;
}

moire::Rectangle Bar::box() const {
  const Point side = across();
  const double x = is_round_ ? half_width_ : std::abs(side.x), y = is_round_ ? half_width_ : std::abs(side.y);
  return {std::min(from_.x, to_.x) - x, std::min(from_.y, to_.y) - y, std::max(from_.x, to_.x) + x,
          std::max(from_.y, to_.y) + y};
}

bool Ring::contains(Point p) const {
  return Disk{center, outer}.contains(p) && !(inner > 0 && Disk{center, inner}.contains(p));
}

Spans Ring::meet(const Ray& ray) const {
  Spans spans;
  const auto whole = Disk{center, outer}.meet(ray);
  if (!whole) return spans;
  const auto hole = inner > 0 ? Disk{center, inner}.meet(ray) : std::nullopt;
  if (hole) {
    spans.add({whole->begin, hole->begin});
    spans.add({hole->end, whole->end});
  } else {
    spans.add(*whole);
  }
  return spans;
}

moire::Rectangle Ring::box() const { return {center.x - outer, center.y - outer, center.x + outer, center.y + outer}; }

std::optional<Shape> shape_of(const moire::LineCurve& line) {
  const bool has_length = line.from != line.to;
  if (line.width == 0 || (!has_length && line.cap == moire::Cap::butt)) return std::nullopt;
  const double half = line.width / 2;
  if (line.cap != moire::Cap::square) return Bar(line.from, line.to, half, line.cap == moire::Cap::round);
  const double dx = has_length ? line.to.x - line.from.x : 1, dy = line.to.y - line.from.y;
  const double length = std::hypot(dx, dy), bx = dx / length * half, by = dy / length * half;
  return Bar({line.from.x - bx, line.from.y - by}, {line.to.x + bx, line.to.y + by}, half, false);
}

std::optional<Shape> shape_of(const moire::CircleCurve& circle) {
  if (circle.width == 0) return std::nullopt;
  const double half = circle.width / 2;
  return Ring{circle.center, std::max(0.0, circle.radius - half), circle.radius + half};
}

}  // namespace primitives
