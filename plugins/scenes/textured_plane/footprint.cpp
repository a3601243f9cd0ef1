#include "footprint.h"

#include <algorithm>
#include <limits>

namespace textured_plane {

namespace {

// As seen from a point, (u, v).
Linear moved(const Linear& l, double u, double v) { return {l.u, l.v, l(u, v)}; }

}  // namespace

Footprint::Footprint(const View& view, int x, int y) : s0_(view.s0()), t0_(view.t0()) {
  const double u = x - view.center().x, v = y - view.center().y;
  s_ = moved(view.s(), u, v);
  t_ = moved(view.t(), u, v);
  fall_ = moved(view.fall(), u, v);
  const Linear nearness = moved(view.nearness(), u, v);
  const auto [ground, sky] =
      Convex::rectangle(0, 0, 1, 1).split([&](const moire::Point& p) { return fall_(p.x, p.y); });
  const auto [near, far] = ground.split([&](const moire::Point& p) { return nearness(p.x, p.y); });
  sky_ = sky.area();
  far_ = far.area();
  if (near.area() > 0) near_ = near;
}

std::pair<std::int64_t, std::int64_t> Footprint::range(const Convex& part, const Linear& distance,
                                                       const Place& origin) const {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const moire::Point& p : part) {
    const double at = distance(p.x, p.y) / fall_(p.x, p.y);
    low = std::min(low, at);
    high = std::max(high, at);
  }
  return {origin.texel(low), origin.texel(high)};
}

TexelBox Footprint::box() const {
  const auto [i0, i1] = range(near_, s_, s0_);
  const auto [j0, j1] = range(near_, t_, t0_);
  return {i0, i1, j0, j1};
}

}  // namespace textured_plane
