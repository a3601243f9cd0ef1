// The walk over the voxels under a ray, near to far: after Cohen-Or 1997, sections 3 and 4, with every voxel a box.
//
// A walk has its own axes: p is the axis along which the ray advances most, q the other one, both turned so that the
// ray rises in p and does not fall in q. Mirrored maps look the same from both sides of an edge, so turning costs
// nothing. Distances x along a ray are measured in p, in voxels of level 0, from the eye; slopes are heights per such a
// voxel.
//
// Whether a voxel is met is decided by one comparison that depends on voxel, plane and slope alone, never on where the
// walk began. So within one vertical plane a walk that goes on from the last voxel met sees, to the bit, what a walk
// from the eye sees.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "camera.h"
#include "view.h"

namespace heightfield {

// A vertical plane through the eye.
struct Plane {
  bool swapped;         // p is y
  bool flip_p, flip_q;  // p and q are turned round
  double m;             // advance in q for a voxel in p, 0 .. 1

  bool same_octant(const Plane& other) const {
    return swapped == other.swapped && flip_p == other.flip_p && flip_q == other.flip_q;
  }
  // The p component of a direction.
  double along(Direction d) const {
    const double p = swapped ? d.y : d.x;
    return flip_p ? -p : p;
  }
  // Its q component.
  double across(Direction d) const {
    const double q = swapped ? d.x : d.y;
    return flip_q ? -q : q;
  }
};

inline Plane plane_of(Direction d) {
  const double ax = std::abs(d.x), ay = std::abs(d.y);
  const bool swapped = ay > ax;
  const double p = swapped ? d.y : d.x, q = swapped ? d.x : d.y;
  return {swapped, p < 0, q<0, std::max(ax, ay)> 0 ? std::min(ax, ay) / std::max(ax, ay) : 0};
}

// Straight down is a slope of this size: no ray through a sample point is as steep.
constexpr double least_advance = 1e-12;

// What of a voxel is met: its box, or a thin wall at its near side, as the figures of the paper have it.
enum class Face { box, near };

// The voxel a walk stands at.
struct Voxel {
  const Cell* cell;
  double x0, x1;      // where the ray's track enters and leaves it
  std::int64_t p, q;  // voxels of the walk's level, in the walk's axes
};

// `grid`: every voxel under the track is visited. Otherwise one for each step in p, that under the middle of the step;
// of walls, that where the step begins.
template <bool grid>
class Walk {
 public:
  explicit Walk(const View& view)
      : view_(view), sure_distance_(view.far / std::hypot(view.spacing_x, view.spacing_y)) {}

  // Stands at or before the first voxel that can be met by rays of `slope` or steeper upward.
  void start(const Plane& plane, double slope);

  // Goes on in another plane from the voxel reached, or `back` voxels before it. Requires: the same octant.
  void turn(const Plane& plane, int back);

  // Visits, from where the walk stands, every voxel that rises above the ray of `slope`: visit(voxel, slope) may raise
  // the slope, and ends the climb at that voxel by returning false. Otherwise it ends at the far limit.
  // `descends`: the slope is and stays below 0, so that of every box only the far edge counts.
  template <Face face, bool descends, class Visit>
  void climb(double slope, Visit&& visit);

  // Steps from the walk's beginning to a voxel. Requires: the walk has not entered another level since it stood there.
  std::int64_t steps_to(const Voxel& voxel) const { return place_of_level_ + voxel.p + (grid ? voxel.q : 0); }
  // Voxels between the last one counted and that so many steps from the beginning; 1 for the first.
  std::uint64_t count(std::int64_t index) {
    const std::int64_t steps = counted_ == nothing ? 1 : index - counted_;
    counted_ = index;
    return static_cast<std::uint64_t>(steps);
  }

  moire::TexelIndex index(const Voxel& voxel) const {
    const std::int64_t p = place(voxel.p, plane_.flip_p, shift_p_), q = place(voxel.q, plane_.flip_q, shift_q_);
    return plane_.swapped ? moire::TexelIndex{level_, q, p} : moire::TexelIndex{level_, p, q};
  }
  moire::Element element(const Voxel& voxel) const {
    const moire::TexelIndex at = index(voxel);
    return moire::texel_element(at.level, at.i, at.j);
  }

  // True if the track enters the voxel through a side across p, and not through one across q.
  bool enters_along_p(const Voxel& voxel) const {
    return voxel.x0 <= std::max(static_cast<double>(voxel.p) * width_ - eye_p_, 0.0);
  }
  // The part of the walk that lies ahead within one level, for those who step it themselves. In voxels of the level.
  struct Leg {
    int level;
    double p, end, end_of_level;  // where it stands, and where it ends
    double stop;                  // x of the far limit, infinite where `end` comes before that in every plane
    double sure_end;              // up to here the far limit lies ahead in every plane
    double place;                 // what to add to p to count steps over all levels
    double eye_p, eye_q;          // voxels of level 0, reduced to one mirror period
    std::int64_t shift_q;         // what was taken away from the latter
  };
  Leg leg() const;
  // Goes on beyond the end of a leg stepped so far in a plane with this m. False: the far limit is reached.
  bool next_leg(const Leg& stepped, double m);

  const Plane& plane() const { return plane_; }
  // Across coordinate of the track at distance x, in the walk's axes.
  double across(double x) const { return eye_q_ + x * plane_.m; }

 private:
  static constexpr std::int64_t nothing = std::numeric_limits<std::int64_t>::min();
  static constexpr std::int64_t endless = std::int64_t{1} << 52;
  static constexpr double endless_distance = std::numeric_limits<double>::infinity();

  std::int64_t place(std::int64_t walk_place, bool flip, std::int64_t shift) const {
    const std::int64_t unreduced = walk_place + (shift >> level_);
    return flip ? -1 - unreduced : unreduced;
  }
  void set_axes(const Plane& plane);
  // World units over the ground for an advance of one voxel in p.
  double unit() const;
  // Where a walk goes on that stands at p, x0 along the track: behind the voxels up to the end of p's block of summits,
  // but not beyond `end`, if none of these rises above the ray; else at p.
  template <bool descends>
  std::int64_t behind_hidden(std::int64_t p, double x0, double slope, std::int64_t end) const;
  // Finds how far to walk from here in one go: as far as all planes see, and beyond that to the far limit of this one.
  void find_end(double unit);
  std::int64_t sure_end() const {
    return static_cast<std::int64_t>(std::floor((eye_p_ + sure_distance_) * inverse_width_));
  }
  bool ends_at_far_limit() const { return stop_ < endless_distance && end_ < end_of_level_; }
  // First step of the walk, in voxels of level 0, that belongs to `level`. Whole voxels only, but for the eye's own.
  std::int64_t begin_of_level(int level, double unit) const;
  // Finds level and end of the part of the walk that holds step `p0` of level 0, and stands at it. False: beyond `far`.
  bool enter(std::int64_t p0);
  // The same, going on with the count of steps.
  bool enter_counted(std::int64_t p0);

  const View& view_;
  double sure_distance_;  // no nearer lies the far limit in any plane, in p
  Plane plane_{};
  double eye_p_ = 0, eye_q_ = 0;            // reduced to one mirror period
  std::int64_t shift_p_ = 0, shift_q_ = 0;  // what was taken away, in voxels of level 0
  int level_ = 0;
  std::int64_t p_ = 0, end_ = 0, end_of_level_ = 0;  // in voxels of level_
  double stop_ = 0;                                  // x of the far limit
  std::int64_t place_of_level_ = 0, counted_ = nothing;
  // Of level_.
  double width_ = 1, inverse_width_ = 1;
  const Cell* cells_ = nullptr;
  struct Axis {
    const std::int32_t* places = nullptr;  // where the cells of an index are, for indices from 0 to size - 1
    std::int64_t size = 0, period = 0;
    std::int64_t offset = 0;  // from the walk's index to one of the table, a multiple of the period

    // Chooses the offset that leads to the first period.
    void renew(std::int64_t index) {
      if (index + offset >= period || index + offset < 0) offset = -(index / period) * period;
    }
  };
  Axis axis_p_, axis_q_;
};

template <bool grid>
void Walk<grid>::set_axes(const Plane& plane) {
  plane_ = plane;
  const Voxels::Level& finest = view_.voxels->level(0);
  const auto reduce = [](double at, int period, double& reduced, std::int64_t& shift) {
    shift = static_cast<std::int64_t>(std::floor(at / period)) * period;
    reduced = at - static_cast<double>(shift);
  };
  const double p = plane.swapped ? view_.y : view_.x, q = plane.swapped ? view_.x : view_.y;
  const int period_p = plane.swapped ? finest.row_period() : finest.column_period();
  const int period_q = plane.swapped ? finest.column_period() : finest.row_period();
  reduce(plane.flip_p ? -p : p, period_p, eye_p_, shift_p_);
  reduce(plane.flip_q ? -q : q, period_q, eye_q_, shift_q_);
}

template <bool grid>
void Walk<grid>::start(const Plane& plane, double slope) {
  set_axes(plane);
  const double eye_above = view_.z - view_.voxels->highest();
  double x = 0;
  if (slope < 0 && eye_above > 0)
    x = std::min(eye_above / -slope, view_.far / std::min(view_.spacing_x, view_.spacing_y));
  const double p0 = std::max(std::floor(eye_p_), std::floor(eye_p_ + x) - 1);
  if (!enter(static_cast<std::int64_t>(p0))) end_ = p_;
  const std::int64_t q = grid ? static_cast<std::int64_t>(across(x) * std::ldexp(1.0, -level_)) : 0;
  if (counted_ != nothing) counted_ = place_of_level_ + p_ + q;
}

template <bool grid>
void Walk<grid>::turn(const Plane& plane, int back) {
  if (plane.m != plane_.m) {
    plane_.m = plane.m;
    if (stop_ < endless_distance) {
      const bool stopped = p_ >= end_;
      const double last_stop = stop_;
      find_end(unit());
      if (stopped && stop_ > last_stop) --p_;  // only a part of that voxel was within the far limit
    }
  }
  if (back > 0) {
    const auto first = static_cast<std::int64_t>(eye_p_);
    enter_counted(std::max(first, (p_ - back) << level_));
  }
}

template <bool grid>
double Walk<grid>::unit() const {
  const double spacing_p = plane_.swapped ? view_.spacing_y : view_.spacing_x;
  const double spacing_q = plane_.swapped ? view_.spacing_x : view_.spacing_y;
  return std::sqrt(spacing_p * spacing_p + plane_.m * plane_.m * spacing_q * spacing_q);
}

template <bool grid>
void Walk<grid>::find_end(double unit) {
  const std::int64_t sure = sure_end();
  if (p_ < sure) {
    stop_ = endless_distance;
    end_ = std::min(end_of_level_, sure);
  } else {
    stop_ = view_.far / unit;
    end_ = std::min(end_of_level_, static_cast<std::int64_t>(std::ceil((eye_p_ + stop_) * inverse_width_)));
  }
}

template <bool grid>
std::int64_t Walk<grid>::begin_of_level(int level, double unit) const {
  const double x = view_.level_starts[static_cast<std::size_t>(level)] / unit;
  const double begin = std::ldexp(eye_p_ + x, -level);
  return static_cast<std::int64_t>(x > 0 ? std::ceil(begin) : std::floor(begin)) << level;
}

template <bool grid>
bool Walk<grid>::enter(std::int64_t p0) {
  const double unit_here = unit();
  const int levels = static_cast<int>(view_.level_starts.size());
  level_ = 0;
  std::int64_t end = endless;
  while (level_ + 1 < levels) {
    end = begin_of_level(level_ + 1, unit_here);
    if (end > p0) break;
    end = endless;
    ++level_;
  }
  p_ = p0 >> level_;
  width_ = std::ldexp(1.0, level_);
  inverse_width_ = std::ldexp(1.0, -level_);
  end_of_level_ = end >> level_;
  find_end(unit_here);

  const Voxels::Level& level = view_.voxels->level(level_);
  cells_ = level.cells.data();
  const auto axis = [](const std::vector<std::int32_t>& places, int period) {
    return Axis{places.data(), static_cast<std::int64_t>(places.size()) - steps_ahead, period, 0};
  };
  axis_p_ = plane_.swapped ? axis(level.rows, level.row_period()) : axis(level.columns, level.column_period());
  axis_q_ = plane_.swapped ? axis(level.columns, level.column_period()) : axis(level.rows, level.row_period());
  return p_ < end_ && static_cast<double>(p_) * width_ - eye_p_ < stop_;
}

template <bool grid>
bool Walk<grid>::enter_counted(std::int64_t p0) {
  const double x = std::max(static_cast<double>(p0) - eye_p_, 0.0);
  const auto place = [&] {
    return (p0 >> level_) + (grid ? static_cast<std::int64_t>(std::ldexp(across(x), -level_)) : 0);
  };
  const std::int64_t before = place_of_level_ + place();
  const bool entered = enter(p0);
  if (!entered) end_ = p_;
  place_of_level_ = before - place();
  return entered;
}

template <bool grid>
typename Walk<grid>::Leg Walk<grid>::leg() const {
  const auto real = [](std::int64_t n) { return static_cast<double>(n); };
  return {level_, real(p_), real(end_), real(end_of_level_), stop_, real(sure_end()), real(place_of_level_),
          eye_p_, eye_q_,   shift_q_};
}

template <bool grid>
bool Walk<grid>::next_leg(const Leg& stepped, double m) {
  plane_.m = m;
  p_ = static_cast<std::int64_t>(stepped.p);
  end_ = static_cast<std::int64_t>(stepped.end);
  stop_ = stepped.stop;
  return !ends_at_far_limit() && enter_counted(end_ << level_);
}

template <bool grid>
template <bool descends>
[[gnu::noinline]] std::int64_t Walk<grid>::behind_hidden(std::int64_t p, double x0, double slope,
                                                         std::int64_t end) const {
  const Summits& summits = view_.voxels->level(level_).summits;
  const auto at_p = static_cast<int>((p + axis_p_.offset) % axis_p_.period);
  const std::int64_t run_end = std::min(end, p + summits.length(plane_.swapped, at_p));
  const double x1 = std::min(static_cast<double>(run_end) * width_ - eye_p_, stop_);
  const auto q0 = static_cast<std::int64_t>(std::ldexp(across(x0), -level_));
  const auto q1 = static_cast<std::int64_t>(std::ldexp(across(x1), -level_));
  const auto at_q = static_cast<int>((q0 + axis_q_.offset) % axis_q_.period);
  const float highest = summits.highest({plane_.swapped, at_p, at_q, static_cast<int>(q1 - q0)});
  return highest - view_.z > slope * (descends || slope < 0 ? x1 : x0) ? p : run_end;
}

template <bool grid>
template <Face face, bool descends, class Visit>
[[gnu::always_inline]] inline void Walk<grid>::climb(double slope, Visit&& visit) {
  const double z = view_.z, eye_p = eye_p_;
  const std::int64_t patience = view_.patience();
  while (p_ < end_ || (!ends_at_far_limit() && enter_counted(end_ << level_))) {
    // Across, in voxels of the level: scaling by a power of two changes no bits.
    const double width = width_, stop = stop_, eye_q = eye_q_ * inverse_width_, m = plane_.m * inverse_width_;
    double x0 = std::max(static_cast<double>(p_) * width - eye_p, 0.0);
    if (!descends && slope >= 0 && view_.voxels->highest() - z <= slope * x0) return;

    // A lap: as far as the tables of places reach. q never advances faster than p; it may enter one more voxel in the
    // last step.
    auto q0 = static_cast<std::int64_t>(eye_q + x0 * m);
    axis_p_.renew(p_);
    axis_q_.renew(q0);
    const std::int64_t lap_end =
        std::min(end_, p_ + std::min(axis_p_.size - (p_ + axis_p_.offset), axis_q_.size - (q0 + axis_q_.offset) - 2));
    const Cell* const cells = cells_;
    const std::int32_t* const places_p = axis_p_.places;
    const std::int32_t* const places_q = axis_q_.places;
    const std::int64_t offset_p = axis_p_.offset, offset_q = axis_q_.offset;

    // Cells are fetched some steps before they are looked at: no cache holds a large map.
    const double ahead = steps_ahead * width;
    std::int64_t p = p_;
    double next = static_cast<double>(p_ + 1) * width;
    std::int64_t try_at = p + patience;
    for (; p < lap_end; ++p, next += width) {
      if (p >= try_at) {
        const std::int64_t behind = behind_hidden<descends>(p, x0, slope, lap_end);
        if (behind == lap_end) {
          p = behind;
          break;
        }
        try_at = behind == p ? p + Summits::block : behind;
        if (behind > p) {
          p = behind;
          next = static_cast<double>(p + 1) * width;
          x0 = std::min(static_cast<double>(p) * width - eye_p, stop);
          q0 = static_cast<std::int64_t>(eye_q + x0 * m);
        }
      }
      const double x1 = std::min(next - eye_p, stop);
      const std::int32_t place_p = places_p[p + offset_p];
      const auto ahead_q = static_cast<std::int64_t>(eye_q + (x1 + ahead) * m);
      __builtin_prefetch(cells + (places_p[p + offset_p + steps_ahead] + places_q[ahead_q + offset_q]));
      const auto met = [&](std::int64_t q, double from, double to) {
        const Cell* cell = cells + (place_p + places_q[q + offset_q]);
        const bool far_edge = face == Face::box && (descends || slope < 0);
        if (!(cell->height - z > slope * (far_edge ? to : from))) return true;
        try_at = p + patience;
        return visit(Voxel{cell, from, to, p, q}, slope);
      };
      if constexpr (grid) {
        const auto q1 = static_cast<std::int64_t>(eye_q + x1 * m);
        bool climbs = true;
        double from = x0;
        for (; climbs && q0 < q1; ++q0) {
          const double crossing = std::clamp((static_cast<double>(q0 + 1) - eye_q) / m, from, x1);
          if (crossing > from) climbs = met(q0, from, crossing);
          from = crossing;
        }
        if (climbs && from < x1) climbs = met(q0, from, x1);
        if (!climbs) break;
      } else {
        const double place = face == Face::near ? x0 : std::max(next - width / 2 - eye_p, 0.0);
        if (!met(static_cast<std::int64_t>(eye_q + place * m), x0, x1)) break;
      }
      x0 = x1;
    }
    p_ = p;
    if (p < lap_end) return;
  }
}

}  // namespace heightfield
