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

// The way that a ray goes over the ground: its own, or that of its column in the picture's middle row.
enum class Azimuth { pixel, column };

// What rays meet. Compiled into the loops.
struct Model {
  bool grid = true;  // every voxel under a ray, or one a step along its major axis
  Azimuth azimuth = Azimuth::pixel;
  Face face = Face::box;
  friend bool operator==(const Model&, const Model&) = default;
};

// What lines weigh what they see by: its length in the image, or its height where it stands.
enum class Weights { area, height };

// How a frame looks.
struct Manner {
  Model model;
  bool resume = true;  // rays above one another go on where the last one ended
  int retrace = 0;     // voxels to go back before they do
  Weights weights = Weights::area;
  bool side_by_side = true;  // upright lines, in the machine's vectors; changes no bit
};

// What a stretch of a line sees of one voxel, or of the sky.
struct Run {
  double length;  // in the image, in pixels
  double rise;    // of what is seen, in the heights' unit at the distance of the edge that ends the voxel; of the sky 0
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
  template <Model model, class Met, class Missed>
  void rays(std::span<const moire::SamplePoint> points, moire::Counters& counters, Met met, Missed missed) const;

  // Calls add(slot, run, walk, voxel, direction, sum) for each visible run of the line's stretches, the slots from
  // first_slot on, voxel null for the sky, and finish(slot, sum) after each stretch; `sum` begins empty. What a stretch
  // sees is exact in the vertical plane through its middle (column azimuth: in the plane of its column): along lines
  // through the nadir point that is the plane of the line itself. Error: the line is neither upright nor through the
  // nadir point.
  template <Model model, Weights weights = Weights::area, class Add, class Finish>
  void stretches(const moire::ImageLine& line, std::size_t first_slot, moire::Counters& counters, Add add,
                 Finish finish) const;

  // How rays and planes change along an image line.
  struct Course {
    Direction start, step;  // the ray at its begin, and what a pixel along it adds
    // A line through the nadir point lies in one vertical plane, best known at its end far from there; with the azimuth
    // of its column an upright line does too. Beyond the point it is seen the other way.
    bool in_one_plane;
    Direction ahead;              // in that plane
    Plane near_side, other_side;  // of the nadir or zenith point
    double turning;  // distance where elevation turns: at that point, and on other upright lines at its height
  };
  // Error: the line is neither upright nor through the nadir point.
  template <Azimuth azimuth>
  Course course_of(moire::Point from, moire::Point to) const;

  // Where a ray of this slope, which rises above nothing before, meets the voxel's box: its near wall or its top.
  template <Face face>
  double meeting(const Voxel& voxel, double slope) const {
    if (face == Face::near) return voxel.x0;
    const double top = voxel.cell->height - view_.z;
    return slope < 0 ? std::clamp(top / slope, voxel.x0, voxel.x1) : voxel.x0;
  }

  // The place on the texture of the track's point at distance x over a voxel: on its top, or on the wall at x. Its
  // derivatives are those of a ray that goes its own way, whatever the azimuth.
  template <Face face, bool grid>
  moire::SurfacePoint surface_point(const Walk<grid>& walk, const Voxel& voxel, double x, Direction d) const;

 private:
  // The way over the ground of the column at x in the picture's middle row.
  Direction column_direction(double x) const { return camera_.direction(x, size_.height / 2.0); }
  // The plane in which the ray through a point is followed.
  template <Azimuth azimuth>
  Plane plane_at(const moire::SamplePoint& point, const Direction& direction) const {
    if (azimuth == Azimuth::pixel) return plane_of(direction);
    const Plane plane = plane_of(column_direction(point.x));
    return advance<azimuth>(plane, direction) < 0 ? plane_of(-1 * column_direction(point.x)) : plane;
  }
  // How far a ray of this direction goes in the plane in which it is followed, in voxels of p. With the azimuth of its
  // column, which need not be its own, that is its advance over the ground in the column's direction: rows stay where
  // they are. Cohen-Or 1997, eq. 2, taken by the letter divides by the advance in p, which raises or lowers a place by
  // sin(2 elevation) / 2 tan(azimuth from p) times the angle between both azimuths, and tears the picture at 45
  // degrees. The error of area sampling does not tell which one the paper used: on Puget Sound (relief 30, yaw 20) the
  // RMSE to the truth is 23.3, 19.1, 7.3 levels at pitch 40, 20, 5 this way, 24.5, 19.3, 7.3 that way.
  template <Azimuth azimuth>
  double advance(const Plane& plane, const Direction& direction) const {
    if (azimuth == Azimuth::pixel) return plane.along(direction);
    const double ratio =
        plane.swapped ? view_.spacing_x / view_.spacing_y : view_.spacing_y / view_.spacing_x;  // q to p
    const double weight = plane.m * ratio * ratio;
    return (plane.along(direction) + weight * plane.across(direction)) / (1 + weight * plane.m);
  }

  moire::ImageSize size_;
  View view_;
  Camera camera_;
  Manner manner_;
};

template <Model model, class Met, class Missed>
void Look::rays(std::span<const moire::SamplePoint> points, moire::Counters& counters, Met met, Missed missed) const {
  Walk<model.grid> walk(view_);
  bool walking = false;
  moire::SamplePoint last;
  counters.queries += points.size();
  for (std::size_t k = 0; k < points.size(); ++k) {
    const moire::SamplePoint& point = points[k];
    const Direction direction = camera_.direction(point.x, point.y);
    const Plane plane = plane_at<model.azimuth>(point, direction);
    const double slope = direction.z / std::max(advance<model.azimuth>(plane, direction), least_advance);

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
      walk.template climb<model.face, true>(slope, meet);
    } else {
      walk.template climb<model.face, false>(slope, meet);
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

template <Azimuth azimuth>
Look::Course Look::course_of(moire::Point from, moire::Point to) const {
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
  const Direction ahead = radial ? far_end : column_direction(from.x);
  const Plane near_side = plane_of(ahead);
  const bool in_one_plane = radial || azimuth == Azimuth::column;
  const double turning = in_one_plane ? -advance<azimuth>(near_side, start) / advance<azimuth>(near_side, step)
                                      : (nadir.y / nadir.w - from.y) / uy;
  return {start, step, in_one_plane, ahead, near_side, plane_of(-1 * ahead), turning};
}

template <Model model, Weights weights, class Add, class Finish>
void Look::stretches(const moire::ImageLine& line, std::size_t first_slot, moire::Counters& counters, Add add,
                     Finish finish) const {
  const auto& [from, to, cuts] = line;
  const Course course = course_of<model.azimuth>(from, to);
  const auto& [start, step, in_one_plane, ahead, near_side, other_side, turning] = course;

  Walk<model.grid> walk(view_);
  bool walking = false;
  double reached = 0;  // where the last stretch ended
  const auto look_along = [&](std::size_t slot, double t0, double t1) __attribute__((always_inline)) {
    const Direction direction = start + (t0 + t1) / 2 * step;
    const Plane plane = !in_one_plane                                      ? plane_of(direction)
                        : advance<model.azimuth>(near_side, direction) < 0 ? other_side
                                                                           : near_side;
    const double p0 = advance<model.azimuth>(plane, start), p1 = advance<model.azimuth>(plane, step);
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
    const auto deposit = [&](double until, const Voxel* voxel, double rise = 0) __attribute__((always_inline)) {
      if (until > at) add(slot, Run{until - at, rise}, walk, voxel, direction, sum);
      at = until;
    };
    std::uint64_t hits = 0;
    std::int64_t last = 0;
    const auto see = [&](auto descends, const Voxel& voxel, double& slope) __attribute__((always_inline)) {
      ++hits;
      last = walk.steps_to(voxel);
      const double top = voxel.cell->height - view_.z;
      constexpr bool boxes = model.face == Face::box;
      if (top >= s1 * (boxes && (descends || s1 < 0) ? voxel.x1 : voxel.x0)) {
        const double x = boxes && top < 0 ? voxel.x1 : voxel.x0;
        deposit(end_at, &voxel, weights == Weights::area ? 0 : (s1 - slope) * x);
        return false;
      }
      // The image of the edge that ends what is seen of the box: the far one of a top below the eye, else the near one.
      const double x = boxes && (descends || top < 0) ? voxel.x1 : voxel.x0;
      const double until = (top * turned_p0 - turned_z * x) / (step.z * x - top * p1);
      deposit(std::min(std::max(until, at), end_at), &voxel, weights == Weights::area ? 0 : top - slope * x);
      slope = std::min(top / x, s1);
      return true;
    };
    if (s1 < 0) {
      walk.template climb<model.face, true>(
          s0, [&](const Voxel& voxel, double& slope)
                  __attribute__((always_inline)) { return see(std::true_type{}, voxel, slope); });
    } else {
      walk.template climb<model.face, false>(
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

template <Face face, bool grid>
moire::SurfacePoint Look::surface_point(const Walk<grid>& walk, const Voxel& voxel, double x, Direction d) const {
  const moire::TexelIndex at = walk.index(voxel);
  const double width = std::ldexp(1.0, at.level), inset = width * 1e-9;
  const Plane& plane = walk.plane();
  const double p = plane.flip_p ? -x : x;
  const double q = plane.flip_q ? -x * plane.m : x * plane.m;
  const double east = plane.swapped ? q : p, south = plane.swapped ? p : q;  // of the eye
  const auto inside = [&](double coordinate, std::int64_t texel) {
    const double low = static_cast<double>(texel) * width;
    return std::clamp(coordinate, low + inset, low + width - inset);
  };
  moire::SurfacePoint point;
  point.hit = {walk.element(voxel), color_of(*voxel.cell)};
  point.textured = true;
  point.level = at.level;
  point.s = inside(view_.x + east, at.i);
  point.t = inside(view_.y + south, at.j);

  // How the ray's meeting point with a plane moves: the horizontal one at this height, or that of a near wall.
  const bool across_x = walk.enters_along_p(voxel) != plane.swapped;
  const auto distance = [&](const Direction& v) {  // from the eye, of a direction: towards that plane
    return face == Face::box ? v.z : across_x ? v.x : v.y;
  };
  const double reach = face == Face::box ? voxel.cell->height - view_.z : across_x ? east : south;
  if (distance(d) != 0) {
    const auto moved = [&](const Direction& change, float& ds, float& dt) {
      ds = static_cast<float>(reach / distance(d) * (change.x - d.x / distance(d) * distance(change)));
      dt = static_cast<float>(reach / distance(d) * (change.y - d.y / distance(d) * distance(change)));
    };
    moved(camera_.right(), point.ds_dx, point.dt_dx);
    moved(camera_.down(), point.ds_dy, point.dt_dy);
  }
  return point;
}

}  // namespace heightfield
