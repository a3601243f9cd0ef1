#include "frame.h"

#include <algorithm>
#include <cmath>

namespace textured_plane {

namespace {

// Points far outside the picture may see what has no name.
std::int64_t texel_at(double coordinate) {
  constexpr double most = 0x1p28;
  return static_cast<std::int64_t>(std::floor(std::clamp(coordinate, -most, most - 1)));
}

}  // namespace

PlaneFrame::PlaneFrame(const Camera& camera, const Texels& texels, moire::Color sky, double tolerance)
    : view_(camera), texels_(texels), surroundings_{sky, texels.mean()}, tolerance_(tolerance) {
  check_reach(view_);
}

template <class Near, class Other>
void PlaneFrame::look(std::span<const moire::SamplePoint> points, moire::Counters& counters, Near near,
                      Other other) const {
  counters.queries += points.size();
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double u = points[k].x - view_.center().x, v = points[k].y - view_.center().y;
    const double fall = view_.fall()(u, v);
    if (!(fall > 0)) {
      other(k, moire::Hit{moire::background, surroundings_.sky});
      continue;
    }
    ++counters.hits;
    if (view_.nearness()(u, v) < 0) {
      other(k, moire::Hit{far_ground, surroundings_.far});
    } else {
      near(k, u, v, fall);
    }
  }
}

void PlaneFrame::trace(std::span<const moire::SamplePoint> points, std::span<moire::Hit> hits,
                       moire::Counters& counters) const {
  look(
      points, counters,
      [&](std::size_t k, double u, double v, double fall) {
        hits[k] = texels_.texture().texel(0, texel_at(view_.s0() + view_.s()(u, v) / fall),
                                          texel_at(view_.t0() + view_.t()(u, v) / fall));
      },
      [&](std::size_t k, const moire::Hit& hit) { hits[k] = hit; });
}

void PlaneFrame::locate(std::span<const moire::SamplePoint> points, std::span<moire::SurfacePoint> out,
                        moire::Counters& counters) const {
  const Linear &s = view_.s(), &t = view_.t(), &w = view_.fall();
  look(
      points, counters,
      [&](std::size_t k, double u, double v, double fall) {
        // Quotient rule, distances being from the camera's foot.
        const double ds = s(u, v) / fall, dt = t(u, v) / fall;
        moire::SurfacePoint& point = out[k];
        point.textured = true;
        point.level = 0;
        point.s = view_.s0() + ds;
        point.t = view_.t0() + dt;
        point.hit = texels_.texture().texel(0, texel_at(point.s), texel_at(point.t));
        point.ds_dx = static_cast<float>((s.u - ds * w.u) / fall);
        point.dt_dx = static_cast<float>((t.u - dt * w.u) / fall);
        point.ds_dy = static_cast<float>((s.v - ds * w.v) / fall);
        point.dt_dy = static_cast<float>((t.v - dt * w.v) / fall);
      },
      [&](std::size_t k, const moire::Hit& hit) {
        out[k] = {};
        out[k].hit = hit;
      });
}

double PlaneFrame::integrate(const moire::Filter*, moire::PixelBlock& block) const {
  double bound = 0;
  if (view_.is_aligned()) {
    Strips(view_, texels_, surroundings_).integrate(block);
  } else {
    bound = Quadtree(view_, texels_, surroundings_, tolerance_).integrate(block);
  }
  return bound;
}

}  // namespace textured_plane
