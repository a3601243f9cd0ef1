#include "exact/curves/stroke.h"

#include <limits>
#include <utility>

namespace area {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Digits of the slope whose multiples by up to 2^26 columns are exact.
constexpr double coarse_digits = 0x1p26;

}  // namespace

Stroke::Place Stroke::place(long double u, long double v) {
  const long double column = std::floor(u), row = std::floor(v);
  return {static_cast<double>(column), static_cast<double>(row), static_cast<double>(u - column),
          static_cast<double>(v - row)};
}

Stroke::Stroke(const moire::LineCurve& line) {
  // Extended numbers: what is rounded here is multiplied by the line's length further on.
  long double u[2] = {line.from.x, line.to.x}, v[2] = {line.from.y, line.to.y};
  is_steep_ = std::abs(v[1] - v[0]) > std::abs(u[1] - u[0]);
  if (is_steep_) std::swap(u, v);
  if (u[0] > u[1]) std::swap(u[0], u[1]), std::swap(v[0], v[1]);
  long double du = u[1] - u[0], dv = v[1] - v[0];
  const bool has_length = du != 0;
  if (!(line.width > 0) || (!has_length && line.cap != moire::Cap::square)) return;
  is_empty_ = false;

  long double length = std::sqrt(du * du + dv * dv);
  if (!has_length) du = length = 1;
  const long double half = line.width / 2.0L;
  if (line.cap == moire::Cap::square) {
    u[0] -= half * du / length, v[0] -= half * dv / length;
    u[1] += half * du / length, v[1] += half * dv / length;
  }
  const long double slope = dv / du;
  const long double coarse = std::nearbyint(slope * coarse_digits) / coarse_digits;
  coarse_slope_ = static_cast<double>(coarse);
  fine_slope_ = static_cast<double>(slope - coarse);
  slope_ = static_cast<double>(slope), rise_ = std::abs(slope_);
  level_rise_ = std::max(rise_, 0x1p-500), half_inverse_rise_ = 0.5 / level_rise_;
  half_height_ = static_cast<double>(half * length / du);

  // The middle line where it enters the picture, or about there.
  const long double at = std::clamp(std::floor(u[0]), -0x1p20L, 0x1p20L);
  anchor_ = place(at, v[0] + slope * (at - u[0]));

  // From the line to the corners at its ends.
  const auto across_u = static_cast<double>(half * dv / length), across_v = static_cast<double>(half * du / length);
  for (int k : {0, 1}) ends_[k] = place(u[k], v[k]);
  const double reach = std::abs(across_u);
  // With a margin for what is rounded here: a column too many costs time alone.
  constexpr double margin = 0x1p-30;
  left_ = static_cast<double>(u[0]) - reach - margin, right_ = static_cast<double>(u[1]) + reach + margin;
  inner_left_ = std::ceil(static_cast<double>(u[0]) + reach + margin);
  inner_right_ = std::floor(static_cast<double>(u[1]) - reach - margin);

  // The area is the integral of v over u around the rectangle: along the side of larger v, down the far end, back and
  // up the near end. `sign` says which way u runs there.
  const auto cap = [&](double end_u, double end_v, double sign) {
    return Edge{end_u - reach,
                end_u + reach,
                end_u,
                end_v,
                across_u == 0 ? 0 : -across_v / across_u,
                (across_u > 0 ? sign : -sign)};
  };
  const auto long_edge = [&](double from, double to, const Place& end, double side) {
    return Edge{from, to, end.u - side * across_u, end.v + side * across_v, slope_, side};
  };
  const Place &s = ends_[0], &e = ends_[1];
  const auto u_length = static_cast<double>((u[1] - std::floor(u[0])) - (u[0] - std::floor(u[0])));
  for (int k : {0, 1}) {
    const double side = k == 0 ? 1 : -1, s_corner = s.u - side * across_u, e_corner = e.u - side * across_u;
    start_[k] = long_edge(s_corner, infinity, s, side);
    end_[k] = long_edge(-infinity, e_corner, e, side);
    all_[k] = long_edge(s_corner, s_corner + u_length, s, side);
  }
  start_[2] = all_[2] = cap(s.u, s.v, -1);
  end_[2] = cap(e.u, e.v, 1);
  all_[3] = cap(static_cast<double>(u[1] - std::floor(u[0])), static_cast<double>(v[1] - std::floor(v[0])), 1);
}

std::array<HalfPlane, 4> Stroke::sides(int x, int y) const {
  const double column = is_steep_ ? y : x, row = is_steep_ ? x : y;
  const double height = middle(column, row);
  const auto end = [&](const Place& place, double sign) {
    const double u = place.column - column + place.u, v = place.row - row + place.v;
    return HalfPlane{sign, sign * slope_, -sign * (u + slope_ * v)};
  };
  std::array<HalfPlane, 4> sides{HalfPlane{slope_, -1, height + half_height_},
                                 HalfPlane{-slope_, 1, half_height_ - height}, end(ends_[0], 1), end(ends_[1], -1)};
  if (is_steep_) {
    for (HalfPlane& side : sides) std::swap(side.a, side.b);
  }
  return sides;
}

}  // namespace area
