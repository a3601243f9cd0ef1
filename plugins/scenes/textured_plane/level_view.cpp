#include "level_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace textured_plane {

namespace {

// Pixels. Farther off, the horizon tells rows apart no better than the picture's middle does.
constexpr double horizon_in_reach = 1e4;

}  // namespace

LevelView::LevelView(const View& view)
    : pitch_(view.pitch()),
      height_(view.height()),
      focal_(view.focal()),
      center_x_(view.center().x),
      along_s_(view.yaw().cosine == 0),
      rises_ahead_((along_s_ ? view.yaw().sine : view.yaw().cosine) > 0),
      line0_(along_s_ ? view.t0() : view.s0()),
      place0_(along_s_ ? view.s0() : view.t0()),
      b_((along_s_ ? -view.yaw().sine : view.yaw().cosine) * height_ / focal_),
      from_horizon_(focal_ * std::abs(pitch_.sine) <= horizon_in_reach * pitch_.cosine),
      fall0_(from_horizon_ ? 0 : -pitch_.sine),
      fall_slope_(pitch_.cosine / focal_),
      rows_per_fall_(focal_ / pitch_.cosine),
      top_(view.center().y + (from_horizon_ ? focal_ * pitch_.sine / pitch_.cosine : 0)),
      horizon_(from_horizon_ ? 0 : focal_ * pitch_.sine / pitch_.cosine) {
  // Looking up, all ground that is in front of the camera may lie beyond the limit.
  const bool is_visible = view.far() * pitch_.cosine > height_ * pitch_.sine;
  far_row_ = is_visible ? row_of(view.far()) : std::numeric_limits<double>::infinity();
}

LevelView::Row LevelView::row(int y) const {
  const double top = y - top_, bottom = y + 1 - top_;
  const double horizon = std::clamp(horizon_, top, bottom), limit = std::clamp(far_row_, horizon, bottom);
  Row row{horizon - top, limit - horizon, bottom - limit, limit, bottom};
  // Rounding of `bottom - top` is not to be seen where there is but one thing.
  for (double* share : {&row.sky, &row.far, &row.near}) {
    if (*share == bottom - top) *share = 1;
  }
  return row;
}

// With D the distance ahead, the point's depth is D cos(pitch) - height sin(pitch) = height / W.
double LevelView::ahead(double k) const {
  if (from_horizon_)
    return height_ * focal_ / (k * pitch_.cosine * pitch_.cosine) + height_ * pitch_.sine / pitch_.cosine;
  return height_ * (pitch_.cosine + k / focal_ * pitch_.sine) / fall(k);
}

double LevelView::row_of(double ahead) const {
  const double depth = ahead * pitch_.cosine - height_ * pitch_.sine;
  if (from_horizon_) return focal_ * height_ / (pitch_.cosine * depth);
  return focal_ * (height_ * pitch_.cosine + ahead * pitch_.sine) / depth;
}

}  // namespace textured_plane
