// Convex polygons of the image, cut by straight lines.
#pragma once

#include <array>
#include <utility>

#include <moire/geometry.h>

namespace textured_plane {

class Convex {
 public:
  static Convex rectangle(double x0, double y0, double x1, double y1) {
    Convex result;
    for (const moire::Point& p : {moire::Point{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}) result.add(p);
    return result;
  }

  const moire::Point* begin() const { return points_.data(); }
  const moire::Point* end() const { return points_.data() + count_; }
  bool empty() const { return count_ < 3; }

  // The part where value(point), linear, is not negative, and the part where it is not positive. Both have the same
  // points on the cut, so that their areas sum to the whole's.
  template <class Value>
  std::pair<Convex, Convex> split(Value value) const {
    std::pair<Convex, Convex> parts;
    if (count_ == 0) return parts;
    const moire::Point* from = end() - 1;
    double before = value(*from);
    for (const moire::Point& to : *this) {
      const double after = value(to);
      if ((before < 0 && after > 0) || (before > 0 && after < 0)) {
        const double share = before / (before - after);
        const moire::Point cut{from->x + share * (to.x - from->x), from->y + share * (to.y - from->y)};
        parts.first.add(cut);
        parts.second.add(cut);
      }
      if (after >= 0) parts.first.add(to);
      if (after <= 0) parts.second.add(to);
      from = &to;
      before = after;
    }
    return parts;
  }
  // The part where value(point), linear, is not negative.
  template <class Value>
  Convex part(Value value) const {
    return split(value).first;
  }

  double area() const {
    double doubled = 0;
    for (int k = 2; k < count_; ++k) {
      const moire::Point &a = points_[0], &b = points_[static_cast<std::size_t>(k - 1)],
                         &c = points_[static_cast<std::size_t>(k)];
      doubled += (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    }
    return doubled > 0 ? doubled / 2 : 0;
  }

 private:
  // A pixel cut by horizon, far limit and the four sides of a block has ten corners; rounding may double some.
  static constexpr int most = 20;

  void add(const moire::Point& p) {
    if (count_ < most) points_[static_cast<std::size_t>(count_++)] = p;
  }

  std::array<moire::Point, most> points_;
  int count_ = 0;
};

}  // namespace textured_plane
