// What curves cover in the image, as point sets with closed forms.
//
// A point on an outline belongs to what lies right of it, or below it where the outline runs level: the same rule as
// pixels have, so that shapes that share a straight edge share no point of it, and a disk fills the hole of a ring of
// its radius. Whether a point is on an outline is decided in double; on coordinates of few bits that is exact.
#pragma once

#include <optional>
#include <span>
#include <variant>
#include <vector>

#include <moire/curves.h>
#include <moire/geometry.h>

namespace primitives {

// A straight line in the image, by distance from its origin. (ex, ey) has length 1.
struct Ray {
  moire::Point origin;
  double ex, ey;
};

struct Span {
  double begin, end;
};

// One or two stretches of a ray.
class Spans {
 public:
  void add(Span span) {
    if (span.begin < span.end) spans_[count_++] = span;
  }
  const Span* begin() const { return spans_; }
  const Span* end() const { return spans_ + count_; }

 private:
  Span spans_[2];
  int count_ = 0;
};

struct Disk {
  moire::Point center;
  double radius;  // above 0

  bool contains(moire::Point p) const;
  std::optional<Span> meet(const Ray& ray) const;
};

// A rectangle about the axis from `from` to `to`, and a disk of its half width around either end if it is round.
class Bar {
 public:
  Bar(moire::Point from, moire::Point to, double half_width, bool is_round);

  moire::Point from() const { return from_; }
  moire::Point to() const { return to_; }
  double half_width() const { return half_width_; }
  bool is_round() const { return is_round_; }
  // At a right angle to the axis, clockwise, as long as half the width.
  moire::Point across() const;

  bool contains(moire::Point p) const;
  Spans meet(const Ray& ray) const;
  moire::Rectangle box() const;

 private:
  // At p: 0 at the beginning of the axis and at its end, rising along it; 0 on it, rising across it; all times its
  // length.
  double after_begin(moire::Point p) const { return dx_ * (p.x - from_.x) + dy_ * (p.y - from_.y); }
  double after_end(moire::Point p) const { return dx_ * (p.x - to_.x) + dy_ * (p.y - to_.y); }
  double aside(moire::Point p) const { return dx_ * (p.y - from_.y) - dy_ * (p.x - from_.x); }

  bool is_between_ends(moire::Point p) const;
  bool is_between_sides(moire::Point p) const;
  std::optional<Span> meet_rectangle(const Ray& ray) const;

  moire::Point from_, to_;
  double dx_, dy_;            // the axis; (1, 0) where it has no length
  double half_width_, side_;  // side: what aside() is on the sides
  bool is_round_;
  bool has_begin_, has_low_side_;  // the edge at the beginning belongs to it, and not that at the end; likewise sides
};

// What lies between two circles of one centre; inner 0: a disk.
struct Ring {
  moire::Point center;
  double inner, outer;  // inner < outer

  bool contains(moire::Point p) const;
  Spans meet(const Ray& ray) const;
  moire::Rectangle box() const;
};

using Shape = std::variant<Bar, Ring>;

// Nothing if the curve covers no area. A line without length and square caps is an upright square.
std::optional<Shape> shape_of(const moire::LineCurve& line);
std::optional<Shape> shape_of(const moire::CircleCurve& circle);

inline bool contains(const Shape& shape, moire::Point p) {
  const Bar* const bar = std::get_if<Bar>(&shape);
  return bar ? bar->contains(p) : std::get_if<Ring>(&shape)->contains(p);
}
inline Spans meet(const Shape& shape, const Ray& ray) {
  const Bar* const bar = std::get_if<Bar>(&shape);
  return bar ? bar->meet(ray) : std::get_if<Ring>(&shape)->meet(ray);
}
inline moire::Rectangle box_of(const Shape& shape) {
  return std::visit([](const auto& s) { return s.box(); }, shape);
}

}  // namespace primitives
