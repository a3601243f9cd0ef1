// What one pixel sees of the plane, whatever the view.
#pragma once

#include <cstdint>
#include <tuple>
#include <utility>

#include "convex.h"
#include "place.h"
#include "view.h"

namespace textured_plane {

// Texels i0 .. i1 by j0 .. j1, unwrapped, both ends included.
struct TexelBox {
  std::int64_t i0, i1, j0, j1;

  std::int64_t count() const { return (i1 - i0 + 1) * (j1 - j0 + 1); }
};

// Points are given from the pixel's corner, so that areas have all their digits anywhere in the picture.
class Footprint {
 public:
  Footprint(const View& view, int x, int y);

  // Shares of the pixel.
  double sky() const { return sky_; }
  double far() const { return far_; }
  // The part that sees the texture.
  const Convex& near() const { return near_; }
  // The texels that it meets. Requires: near() is not empty.
  TexelBox box() const;

  // Both parts of a polygon: where s, or t, is not below texel i's, or j's, lower edge, and where it is not above.
  std::pair<Convex, Convex> split_s(const Convex& part, std::int64_t i) const { return split(part, s_, s0_.to(i)); }
  std::pair<Convex, Convex> split_t(const Convex& part, std::int64_t j) const { return split(part, t_, t0_.to(j)); }

  // Of texels' lower edges, from the camera's foot.
  double s_of(std::int64_t i) const { return s0_.to(i); }
  double t_of(std::int64_t j) const { return t0_.to(j); }

  // Calls visit(i, j, area) for every texel seen, unwrapped, row by row. Takes time in proportion to their number.
  template <class Visit>
  void for_each_texel(Visit visit) const;

 private:
  // S and T over W are distances from the camera's foot; all linear in the image point.
  std::pair<Convex, Convex> split(const Convex& part, const Linear& distance, double at) const {
    return part.split([&](const moire::Point& p) { return distance(p.x, p.y) - at * fall_(p.x, p.y); });
  }
  // The first and the last texel of an axis that a part meets.
  std::pair<std::int64_t, std::int64_t> range(const Convex& part, const Linear& distance, const Place& origin) const;

  Linear s_, t_, fall_;
  Place s0_, t0_;
  double sky_, far_;
  Convex near_;
};

template <class Visit>
void Footprint::for_each_texel(Visit visit) const {
  if (near_.empty()) return;
  Convex below = near_;
  const auto [first_row, last_row] = range(near_, t_, t0_);
  for (std::int64_t j = first_row; j <= last_row; ++j) {
    Convex row = below;
    if (j < last_row) std::tie(below, row) = split_t(below, j + 1);
    if (row.empty()) continue;
    const auto [first, last] = range(row, s_, s0_);
    for (std::int64_t i = first; i <= last; ++i) {
      Convex texel = row;
      if (i < last) std::tie(row, texel) = split_s(row, i + 1);
      const double area = texel.area();
      if (area > 0) visit(i, j, area);
    }
  }
}

}  // namespace textured_plane
