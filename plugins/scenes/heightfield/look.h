// Looking at a heightfield: along rays, and along lines of the image. Templates, so that what is done with each voxel
// met is compiled into the walk.
#pragma once

#include <span>
#include <type_traits>
#include <utility>

#include <moire/error.h>
#include <moire/frame.h>
#include <moire/tally.h>
#include <moire/texture.h>

#include "camera.h"
#include "view.h"
#include "walk.h"

namespace heightfield {

// How a frame walks.
struct Manner {
  bool grid = true;    // every voxel under a ray, or one a step along its major axis
  bool resume = true;  // rays above one another go on where the last one ended
  int retrace = 0;     // voxels to go back before they do
};

inline moire::Color color_of(const Cell& cell) { return {cell.rgb[0], cell.rgb[1], cell.rgb[2]}; }

// A camera's look over the voxels.
class Look {
 public:
  Look(moire::ImageSize size, View view, Camera camera, Manner manner)
      : size_(size), view_(std::move(view)), camera_(camera), manner_(manner) {}

  const moire::ImageSize& size() const { return size_; }
  const View& view() const { return view_; }
  const Camera& camera() const { return camera_; }
  const Manner& manner() const { return manner_; }

  // Calls met(k, walk, voxel, direction, slope) or missed(k) for each point.
  template <bool grid, class Met, class Missed>
  void rays(std::span<const moire::SamplePoint> points, moire::Counters& counters, Met met, Missed missed) const;

  // Calls add(slot, weight, walk, voxel, direction, sum) for each visible run of the line's stretches, the slots from
  // first_slot on, voxel null for the sky, and finish(slot, sum) after each stretch; `sum` begins empty. What a stretch
  // sees is exact in the vertical plane through its middle: along lines through the nadir point that is the plane of
  // the line itself. Error: the line is neither upright nor through the nadir point.
  template <bool grid, class Add, class Finish>
  void stretches(const moire::ImageLine& line, std::size_t first_slot, moire::Counters& counters, Add add,
                 Finish finish) const;

  // How rays and planes change along an image line.
  struct Course {
    Direction start, step;  // the ray at its begin, and what a pixel along it adds
    // A line through the nadir point lies in one vertical plane, best known at its end far from there. Beyond the point
    // it is seen the other way.
    Direction far_end;
    Plane near_side, other_side;  // of the nadir or zenith point
    bool radial;                  // such a line
    double turning;  // distance where elevation turns: at that point, and on other upright lines at its height
  };
  // Error: the line is neither upright nor through the nadir point.
  Course course_of(moire::Point from, moire::Point to) const;

  // Where a ray of this slope, which rises above nothing before, meets the voxel's box: its near wall or its top.
  double meeting(const Voxel& voxel, double slope) const {
    const double top = voxel.cell->height - view_.z;
    return slope < 0 ? std::clamp(top / slope, voxel.x0, voxel.x1) : voxel.x0;
  }

  // The place on the texture of the track's point at distance x over a voxel.
  template <bool grid>
  moire::SurfacePoint surface_point(const Walk<grid>& walk, const Voxel& voxel, double x, Direction d) const;

 private:
  moire::ImageSize size_;
  View view_;
  Camera camera_;
  Manner manner_;
};

template <bool grid, class Met, class Missed>
void Look::rays(std::span<const moire::SamplePoint> points, moire::Counters& counters, Met met, Missed missed) const {
  Walk<grid> walk(view_);
  bool walking = false;
  moire::SamplePoint last;
  counters.queries += points.size();
  for (std::size_t k = 0; k < points.size(); ++k) {
    const moire::SamplePoint& point = points[k];
    const Direction direction = camera_.direction(point.x, point.y);
    const Plane plane = plane_of(direction);
    const double slope = direction.z / std::max(plane.along(direction), least_advance);

    const bool resumes = walking && manner_.resume && point.y <= last.y && std::abs(point.x - last.x) <= 1 &&
                         plane.same_octant(walk.plane()) && camera_.rises_upward(point.y) &&
                         camera_.rises_upward(last.y);
    if (resumes) {
      walk.turn(plane, manner_.retrace);
    } else {
      walk.start(plane, slope);
    }
    walking = true;
    last = point;

    bool hit = false;
    const auto meet = [&](const Voxel& voxel, double&) __attribute__((always_inline)) {
      counters.steps += walk.count(walk.steps_to(voxel));
      hit = true;
      met(k, walk, voxel, direction, slope);
      return false;
    };
    if (slope < 0) {
      walk.template climb<true>(slope, meet);
    } else {
      walk.template climb<false>(slope, meet);
    }
    if (hit) {
      ++counters.hits;
    } else {
      missed(k);
    }
  }
}

// Shorter stretches of an image line, in pixels, are not looked at on their own.
constexpr double least_stretch = 1e-9;

inline Look::Course Look::course_of(moire::Point from, moire::Point to) const {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const double ux = (to.x - from.x) / length, uy = (to.y - from.y) / length;
  const Direction start = camera_.direction(from.x, from.y);
  const Direction step = ux * camera_.right() + uy * camera_.down();

  const moire::Pole nadir = camera_.nadir();
  const double off = (nadir.x - from.x * nadir.w) * uy - (nadir.y - from.y * nadir.w) * ux;
  const bool radial = std::abs(off) <= 1e-9 * (std::abs(nadir.x) + std::abs(nadir.y) + size_.width * std::abs(nadir.w));
  const bool upright = from.x == to.x;
  if (!radial && !upright) {
    throw moire::Error("heightfield: an image line is neither upright nor through the nadir point");
  }
  const Direction end = start + length * step;
  const Direction far_end = std::hypot(start.x, start.y) > std::hypot(end.x, end.y) ? start : end;
  const Plane near_side = plane_of(far_end);
  const double turning = radial ? -near_side.along(start) / near_side.along(step) : (nadir.y / nadir.w - from.y) / uy;
  return {start, step, far_end, near_side, plane_of(-1 * far_end), radial, turning};
}

template <bool grid, class Add, class Finish>
void Look::stretches(const moire::ImageLine& line, std::size_t first_slot, moire::Counters& counters, Add add,
                     Finish finish) const {
  const auto& [from, to, cuts] = line;
  const Course course = course_of(from, to);
  const auto& [start, step, far_end, near_side, other_side, radial, turning] = course;

  Walk<grid> walk(view_);
  bool walking = false;
  double reached = 0;  // where the last stretch ended
  const auto look_along = [&](std::size_t slot, double t0, double t1) __attribute__((always_inline)) {
    const Direction direction = start + (t0 + t1) / 2 * step;
    const Plane plane = !radial ? plane_of(direction) : near_side.along(direction) < 0 ? other_side : near_side;
    const double p0 = plane.along(start), p1 = plane.along(step);
    const auto slope_at = [&](double t) { return (start.z + t * step.z) / std::max(p0 + t * p1, least_advance); };
    double s0 = slope_at(t0), s1 = slope_at(t1);
    // Positions on the line, turned where elevation falls along it, so that they rise with the slope.
    const bool rises = s0 <= s1;
    if (!rises) std::swap(t0, t1), std::swap(s0, s1);
    const double turn = rises ? 1 : -1;
    const double end_at = turn * t1, turned_p0 = turn * p0, turned_z = turn * start.z;

    if (walking && manner_.resume && rises && t0 == reached && plane.same_octant(walk.plane())) {
      walk.turn(plane, manner_.retrace);
    } else {
      walk.start(plane, s0);
    }
    walking = true;
    reached = t1;

    double at = turn * t0;
    moire::Tally::Sum sum;
    const auto deposit = [&](double until, const Voxel* voxel) __attribute__((always_inline)) {
      if (until > at) add(slot, until - at, walk, voxel, direction, sum);
      at = until;
    };
    std::uint64_t hits = 0;
    std::int64_t last = 0;
    const auto see = [&](auto descends, const Voxel& voxel, double& slope) __attribute__((always_inline)) {
      ++hits;
      last = walk.steps_to(voxel);
      const double top = voxel.cell->height - view_.z;
      if (top >= s1 * (descends || s1 < 0 ? voxel.x1 : voxel.x0)) {
        deposit(end_at, &voxel);
        return false;
      }
      // The image of the edge that ends what is seen of the box: the far one of a top below the eye, else the near one.
      const double x = descends || top < 0 ? voxel.x1 : voxel.x0;
      const double until = (top * turned_p0 - turned_z * x) / (step.z * x - top * p1);
      deposit(std::min(std::max(until, at), end_at), &voxel);
      slope = std::min(top / x, s1);
      return true;
    };
    if (s1 < 0) {
      walk.template climb<true>(
          s0, [&](const Voxel& voxel, double& slope)
                  __attribute__((always_inline)) { return see(std::true_type{}, voxel, slope); });
    } else {
      walk.template climb<false>(
          s0, [&](const Voxel& voxel, double& slope)
                  __attribute__((always_inline)) { return see(std::false_type{}, voxel, slope); });
    }
    if (at != end_at) deposit(end_at, nullptr);
    finish(slot, sum);
    ++counters.queries;
    counters.hits += hits;
    if (hits > 0) counters.steps += walk.count(last);
  };

  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double t0 = cuts[i], t1 = cuts[i + 1];
    if (!(t0 < t1)) continue;
    // Rounding errors put the turning point of a line that begins there a little into it.
    const bool turns = turning > t0 + least_stretch && turning < t1 - least_stretch;
    const double split = turns ? turning : t1;
    for (const auto& [begin, until] : {std::pair{t0, split}, std::pair{split, t1}}) {
      if (begin < until) look_along(first_slot + i, begin, until);
    }
  }
}

template <bool grid>
moire::SurfacePoint Look::surface_point(const Walk<grid>& walk, const Voxel& voxel, double x, Direction d) const {
  const moire::TexelIndex at = walk.index(voxel);
  const double width = std::ldexp(1.0, at.level), inset = width * 1e-9;
  const Plane& plane = walk.plane();
  const double p = plane.flip_p ? -x : x;
  const double q = plane.flip_q ? -x * plane.m : x * plane.m;
  const auto inside = [&](double coordinate, std::int64_t texel) {
    const double low = static_cast<double>(texel) * width;
    return std::clamp(coordinate, low + inset, low + width - inset);
  };
  moire::SurfacePoint point;
  point.hit = {walk.element(voxel), color_of(*voxel.cell)};
  point.textured = true;
  point.level = at.level;
  point.s = inside(view_.x + (plane.swapped ? q : p), at.i);
  point.t = inside(view_.y + (plane.swapped ? p : q), at.j);

  // How the ray's meeting point with the horizontal plane at this height moves.
  const double top = voxel.cell->height - view_.z;
  if (d.z != 0) {
    const auto moved = [&](const Direction& change, float& ds, float& dt) {
      ds = static_cast<float>(top / d.z * (change.x - d.x / d.z * change.z));
      dt = static_cast<float>(top / d.z * (change.y - d.y / d.z * change.z));
    };
    moved(camera_.right(), point.ds_dx, point.dt_dx);
    moved(camera_.down(), point.ds_dy, point.dt_dy);
  }
  return point;
}

}  // namespace heightfield
