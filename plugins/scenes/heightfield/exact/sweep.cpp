#include "exact/sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/skyline.h"
#include "look.h"

namespace heightfield::exact {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Chords follow the far limit's circle so that no pixel is off by more.
constexpr double chord_error = 1e-10;
constexpr double most_chords = 1 << 20;  // in a wedge

// Hands polygons to the sink, those of the voxel that stands at (p, q).
class Shower {
 public:
  Shower(const Walk<true>& walk, const Projection& projection, moire::PolygonSink& sink)
      : walk_(walk), projection_(projection), sink_(sink) {}

  void stand_at(const Cell* cell, std::int64_t p, std::int64_t q, bool wanted) {
    cell_ = cell;
    p_ = p, q_ = q;
    wanted_ = wanted;
  }

  void operator()(std::span<const Vertex> outline) {
    if (!wanted_) return;
    points_.resize(outline.size());
    bool beyond = false;
    for (std::size_t k = 0; k < outline.size(); ++k) {
      points_[k] = outline[k].at;
      beyond |= Projection::is_beyond(outline[k]);
    }
    if (beyond) projection_.cut(outline, points_);
    if (points_.size() > 2) show(points_);
  }
  void show(std::span<const moire::Point> points) {
    static constexpr std::uint32_t first = 0;
    sink_.polygon(
        {walk_.element(Voxel{cell_, 0, 0, p_, q_}), color_of(*cell_), moire::FillRule::nonzero, points, {&first, 1}});
  }

 private:
  const Walk<true>& walk_;
  const Projection& projection_;
  moire::PolygonSink& sink_;
  const Cell* cell_ = nullptr;
  std::int64_t p_ = 0, q_ = 0;
  bool wanted_ = true;
  std::vector<moire::Point> points_;
};

// The far limit in a wedge: 1 / p of its place at u, straight between places at equal distances in u. The chords cross
// the circle so that each has as much of it on one side as on the other; what a pixel is off by comes from parts of a
// chord at its sides. Of a chord of width d that is at most sqrt(3) / 216 d^3 times the second derivative of 1 / p.
class Rim {
 public:
  Rim(const View& view, const Plane& axes, const Wedge& wedge, const Projection::Scale& pixels)
      : wedge_(wedge),
        spacing_p_(axes.swapped ? view.spacing_y : view.spacing_x),
        spacing_q_(axes.swapped ? view.spacing_x : view.spacing_y),
        far_(view.far) {
    const double tallest =
        std::max(std::abs(view.voxels->highest() - view.z), std::abs(view.voxels->lowest() - view.z));
    // Both sides of a pixel; 1 / p is bent most at u = 0.
    const double error = 2 * std::sqrt(3.0) / 216 * bend(0) * tallest * pixels.per_v * pixels.per_u;
    const double wide = wedge.u1 - wedge.u0;
    chords_ = static_cast<int>(std::clamp(std::ceil(wide * std::cbrt(error / chord_error)), 1.0, most_chords));
    shift_ = wide / chords_ * wide / chords_ / 12;
  }

  double exact(double u) const { return std::hypot(spacing_p_, u * spacing_q_) / far_; }
  double at(double u) const {
    const int k = chord(u);
    const double begin = place(k), end = place(k + 1), first = corner(begin);
    return first + (u - begin) / (end - begin) * (corner(end) - first);
  }
  // Where the chord over u ends.
  double end_after(double u) const {
    int k = chord(u) + 1;
    while (place(k) <= u) ++k;
    return place(k);
  }
  // No fewer are the chords whose inverse distances lie between two.
  std::size_t chords_between(double near, double far) const {
    const auto u = [&](double inverse) {
      const double x = inverse * far_;
      return std::clamp(std::sqrt(std::max(0.0, x * x - spacing_p_ * spacing_p_)) / spacing_q_, wedge_.u0, wedge_.u1);
    };
    return static_cast<std::size_t>((u(near) - u(far)) / (wedge_.u1 - wedge_.u0) * chords_) + 4;
  }

 private:
  // The second derivative of 1 / p.
  double bend(double u) const {
    const double unit = std::hypot(spacing_p_, u * spacing_q_), area = spacing_p_ * spacing_q_;
    return area * area / (unit * unit * unit * far_);
  }
  double corner(double u) const { return exact(u) - shift_ * bend(u); }
  int chord(double u) const {
    const double k = std::floor((u - wedge_.u0) / (wedge_.u1 - wedge_.u0) * chords_);
    return static_cast<int>(std::clamp(k, 0.0, chords_ - 1.0));
  }
  double place(int k) const { return k >= chords_ ? wedge_.u1 : wedge_.u0 + (wedge_.u1 - wedge_.u0) * k / chords_; }

  Wedge wedge_;
  double spacing_p_, spacing_q_, far_;
  int chords_;
  double shift_;
};

class Sweep {
 public:
  Sweep(const View& view, const Plane& axes, const Projection& projection, const Wedge& wedge, const Range& range,
        moire::PolygonSink& sink)
      : view_(view),
        wedge_(wedge),
        range_(range),
        walk_(begun(view, axes)),
        rim_(view, axes, wedge, projection.scale_of(range.part)),
        skyline_(projection, wedge, Shower(walk_, projection, sink)),
        level_(view.voxels->level(0)) {
    const auto leg = walk_.leg();
    eye_p_ = leg.eye_p, eye_q_ = leg.eye_q;
    places_p_ = (axes.swapped ? level_.rows : level_.columns).data();
    places_q_ = (axes.swapped ? level_.columns : level_.rows).data();
    period_p_ = axes.swapped ? level_.row_period() : level_.column_period();
    period_q_ = axes.swapped ? level_.column_period() : level_.row_period();
  }

  std::uint64_t run() {
    if (!(view_.far > 0)) return 0;
    const auto own_p = static_cast<std::int64_t>(std::floor(eye_p_)),
               own_q = static_cast<std::int64_t>(std::floor(eye_q_));
    const Cell& own = cell(own_p, own_q);
    if (own.height > view_.z) {
      skyline_.show().stand_at(&own, own_p, own_q, true);
      skyline_.show().show(range_.part);
      return 1;
    }
    const double highest = view_.voxels->highest() - view_.z;
    std::int64_t p = own_p;
    // No box before this distance reaches up to the picture.
    if (highest < 0 && range_.start < 0)
      p = std::max(p, static_cast<std::int64_t>(eye_p_ + highest / range_.start) - 1);

    const double end = rim_.at(wedge_.u0);
    double lowest = -infinity;
    for (int rows = 1;; ++p, ++rows) {
      const double x0 = std::max(static_cast<double>(p) - eye_p_, 0.0), x1 = static_cast<double>(p + 1) - eye_p_;
      const double r0 = 1 / x0, r1 = 1 / x1;
      if (r0 <= end) break;
      const double above = highest > 0 ? highest * r0 : highest * end;
      if (lowest >= range_.highest || lowest >= above || above < range_.lowest) break;
      if (r1 < rim_.exact(wedge_.u1)) {
        row<true>(p, x0, r0, r1);
      } else {
        row<false>(p, x0, r0, r1);
      }
      if (rows % rows_between_looks == 0) lowest = skyline_.lowest();
    }
    return visited_;
  }

 private:
  static constexpr int rows_between_looks = 8;

  static Walk<true> begun(const View& view, const Plane& axes) {
    Walk<true> walk(view);
    walk.start(axes, 0);
    return walk;
  }
  const Cell& cell(std::int64_t p, std::int64_t q) const {
    return level_.cells[static_cast<std::size_t>(places_p_[p % period_p_] + places_q_[q % period_q_])];
  }

  // The voxels of a row from u0 outward. The rays of a wedge enter a voxel through its side (between azimuths u0 and
  // u1) or its near edge (from there on), and leave it through its far edge (up to next_u0) or its other side (up to
  // next_u1): there they pass into the next voxel, which so begins behind this one. Seen of a box is, above all, the
  // edge by which rays leave it if its top is below the eye, else that by which they enter it; r are inverse distances
  // of edges in p, straight in u.
  template <bool at_rim>
  void row(std::int64_t p, double x0, double r0, double r1) {
    auto q = static_cast<std::int64_t>(eye_q_ + wedge_.u0 * x0);
    std::int64_t k = q % period_q_;
    const std::int64_t at_p = p % period_p_;
    const Cell* const cells = level_.cells.data() + places_p_[at_p];
    const Cell* const cells_ahead = level_.cells.data() + places_p_[at_p + steps_ahead];
    const auto drift = static_cast<std::int64_t>(wedge_.u0 * steps_ahead);
    const double end = wedge_.u1;
    skyline_.begin_row(static_cast<std::size_t>((end - wedge_.u0) / r1) + 4 +
                       (at_rim ? 4 * rim_.chords_between(r0, r1) : 0));

    double u0 = wedge_.u0, u1 = u0;
    for (bool first = true;; first = false) {
      if (at_rim && rim_.at(u0) >= r0) {
        if (!first) skyline_.skip_branch(u1);
        skyline_.skip(end);
        break;
      }
      const Cell& cell = cells[places_q_[k]];
      __builtin_prefetch(cells_ahead + places_q_[k + drift]);
      ++visited_;
      const double top = cell.height - view_.z;
      const bool low = top <= 0;
      skyline_.show().stand_at(&cell, p, q, top * (low ? r1 : r0) >= range_.lowest);

      const double inner = static_cast<double>(q) - eye_q_, outer = inner + 1;
      const double next_u0 = std::max(std::min(outer * r1, end), u1);
      const double next_u1 = std::max(std::min(outer * r0, end), next_u0);
      const bool last = next_u0 >= end;
      // Inverse distances where rays begin and end to enter through the side, and to leave through the other one. The
      // wedge may begin and end between.
      const double begun = inner * r1 < u0 ? u0 / inner : r1;
      const double entered = first || u1 < end ? r0 : u1 / inner;
      const double turned = outer * r1 < u1 ? u1 / outer : r1;
      const double left = next_u1 < end ? r0 : next_u1 / outer;
      if (at_rim) {
        AtRim box{*this, top};
        if (!first) box.template pass<true>(u1, {r1, r1}, {begun, entered});
        box.template pass<false>(next_u0, {turned, turned}, {entered, entered});
        if (!last) {
          box.bend();
          skyline_.fork();
          box.template pass<false>(next_u1, {turned, left}, {entered, entered});
        }
        box.end();
      } else if (low) {
        const double far_edge = top * turned;
        skyline_.begin_chain(far_edge);
        if (!first) skyline_.follow_branch(u1, far_edge);
        skyline_.follow(next_u0, far_edge);
        if (!last) {
          skyline_.bend();
          skyline_.fork();
          skyline_.follow(next_u1, top * left);
        }
        skyline_.end_chain();
      } else {
        const double near_edge = top * entered;
        skyline_.begin_chain(first ? near_edge : top * begun);
        if (!first) {
          skyline_.follow_branch(u1, near_edge);
          skyline_.bend();
        }
        skyline_.follow(next_u0, near_edge);
        if (!last) {
          skyline_.fork();
          skyline_.follow(next_u1, near_edge);
        }
        skyline_.end_chain();
      }
      if (last) break;
      skyline_.rejoin();
      u0 = next_u0, u1 = next_u1;
      ++q;
      if (++k == period_q_) k = 0;
    }
    skyline_.end_row();
  }

  // A line over some u: its values where these begin and end.
  struct Line {
    double begin, end;
    double at(double t) const { return begin == end ? begin : begin + t * (end - begin); }
  };

  // A box of which the far limit may cut something off.
  class AtRim {
   public:
    AtRim(Sweep& sweep, double top) : sweep_(sweep), skyline_(sweep.skyline_), top_(top) {}

    // Up to u, where rays leave and enter the box along these lines.
    template <bool branch>
    void pass(double u, Line leave, Line enter) {
      const double begin = skyline_.u();
      if (!(begin < u)) return go<branch>(u, false, {}, {});
      // The far limit is nowhere nearer than where rays leave: its inverse distance is convex.
      if (sweep_.rim_.at(begin) <= leave.begin && sweep_.rim_.at(u) <= leave.end) {
        const Line& edge = top_ <= 0 ? leave : enter;
        return go<branch>(u, true, top_ * edge.begin, top_ * edge.end);
      }
      for (double a = begin; a < u;) {
        const double b = std::min(u, sweep_.rim_.end_after(a));
        const Line stop{sweep_.rim_.at(a), sweep_.rim_.at(b)};
        const double ta = (a - begin) / (u - begin), tb = b < u ? (b - begin) / (u - begin) : 1;
        chord<branch>(a, b, {leave.at(ta), leave.at(tb)}, {enter.at(ta), enter.at(tb)}, stop);
        a = b;
      }
    }
    void bend() {
      if (on_) skyline_.bend();
    }
    void end() {
      if (on_) skyline_.end_chain();
      on_ = false;
    }

   private:
    // The same where the far limit is straight too.
    template <bool branch>
    void chord(double a, double b, Line leave, Line enter, Line stop) {
      const auto crossing = [&](Line one, Line other) {
        const double before = one.begin - other.begin, after = one.end - other.end;
        return (before < 0) != (after < 0) ? std::clamp(before / (before - after), 0.0, 1.0) : 1.0;
      };
      const double one = top_ <= 0 ? crossing(leave, stop) : 1;
      const double other = enter.begin < infinity ? crossing(enter, stop) : 1;
      const double cuts[] = {0, std::min(one, other), std::max(one, other), 1};
      const auto edge = [&](double t) { return top_ <= 0 ? std::max(leave.at(t), stop.at(t)) : enter.at(t); };
      for (int i = 0; i < 3; ++i) {
        const double t0 = cuts[i], t1 = cuts[i + 1], middle = (t0 + t1) / 2;
        if (!(t0 < t1)) continue;
        const bool within = enter.at(middle) > stop.at(middle);
        go<branch>(t1 < 1 ? a + t1 * (b - a) : b, within, within ? top_ * edge(t0) : 0, within ? top_ * edge(t1) : 0);
      }
    }
    template <bool branch>
    void go(double u, bool within, double v0, double v1) {
      if (within && on_) skyline_.bend();
      if (within && !on_) skyline_.begin_chain(v0);
      if (!within) end();
      on_ = within;
      if (within) {
        branch ? skyline_.follow_branch(u, v1) : skyline_.follow(u, v1);
      } else {
        branch ? skyline_.skip_branch(u) : skyline_.skip(u);
      }
    }

    Sweep& sweep_;
    Skyline<Shower>& skyline_;
    double top_;
    bool on_ = false;
  };

  const View& view_;
  Wedge wedge_;
  Range range_;
  Walk<true> walk_;
  Rim rim_;
  Skyline<Shower> skyline_;
  const Voxels::Level& level_;
  double eye_p_, eye_q_;
  const std::int32_t *places_p_, *places_q_;  // where the cells of an index are
  std::int64_t period_p_, period_q_;
  std::uint64_t visited_ = 0;
};

}  // namespace

std::uint64_t sweep(const View& view, const Plane& axes, const Projection& projection, const Wedge& wedge,
                    const Range& range, moire::PolygonSink& sink) {
  return Sweep(view, axes, projection, wedge, range, sink).run();
}

}  // namespace heightfield::exact
