// The rows of a packet: the planes and rays that its lanes are walked with.
// Compiled once for each kind of vector: its guard lets it in again for the next one.
#if defined(HEIGHTFIELD_PACKET_ROWS_H_TOGGLE) == defined(HWY_TARGET_TOGGLE)
#ifdef HEIGHTFIELD_PACKET_ROWS_H_TOGGLE
#undef HEIGHTFIELD_PACKET_ROWS_H_TOGGLE
#else
#define HEIGHTFIELD_PACKET_ROWS_H_TOGGLE
#endif

#include <algorithm>
#include <span>
#include <vector>

#include "packet_lanes.h"
#include "packet_vectors.h"

HWY_BEFORE_NAMESPACE();

namespace heightfield::HWY_NAMESPACE {

// What the rows of each lane are walked with: row after row, lane after lane; the last row ends it.
struct Row {
  double m, first_slope, last_slope, end;
};

class Rows {
 public:
  // Marks lines of which a row lies in another octant or falls along the line.
  void prepare(const PacketTask& task, std::span<PacketLine> lines);

  std::size_t count() const { return count_; }
  const Row* data() const { return rows_.data(); }
  // The most by which m changes from a row to the next, in any lane.
  double largest_turn() const { return largest_turn_; }

 private:
  std::size_t count_ = 0;
  double largest_turn_ = 0;
  std::vector<Row> rows_;
};

// A row of each lane, field by field.
template <class Vector>
struct RowFields {
  Vector m, first_slope, last_slope, end;
};
template <class Tag>
HWY_INLINE RowFields<hn::Vec<Tag>> load_rows(Tag tag, const Row* const* rows) {
  using V = hn::Vec<Tag>;
  if constexpr (hn::MaxLanes(tag) == 2) {
    const V front0 = hn::LoadU(tag, &rows[0]->m), front1 = hn::LoadU(tag, &rows[1]->m);
    const V back0 = hn::LoadU(tag, &rows[0]->last_slope), back1 = hn::LoadU(tag, &rows[1]->last_slope);
    return {hn::InterleaveLower(tag, front0, front1), hn::InterleaveUpper(tag, front0, front1),
            hn::InterleaveLower(tag, back0, back1), hn::InterleaveUpper(tag, back0, back1)};
  } else if constexpr (hn::MaxLanes(tag) == 4) {
    const V r0 = hn::LoadU(tag, &rows[0]->m), r1 = hn::LoadU(tag, &rows[1]->m);
    const V r2 = hn::LoadU(tag, &rows[2]->m), r3 = hn::LoadU(tag, &rows[3]->m);
    const V even01 = hn::InterleaveLower(tag, r0, r1), even23 = hn::InterleaveLower(tag, r2, r3);
    const V odd01 = hn::InterleaveUpper(tag, r0, r1), odd23 = hn::InterleaveUpper(tag, r2, r3);
    return {hn::ConcatLowerLower(tag, even23, even01), hn::ConcatLowerLower(tag, odd23, odd01),
            hn::ConcatUpperUpper(tag, even23, even01), hn::ConcatUpperUpper(tag, odd23, odd01)};
  } else {
    constexpr hn::Half<Tag> half;
    const auto a = load_rows(half, rows), b = load_rows(half, rows + 4);
    return {hn::Combine(tag, b.m, a.m), hn::Combine(tag, b.first_slope, a.first_slope),
            hn::Combine(tag, b.last_slope, a.last_slope), hn::Combine(tag, b.end, a.end)};
  }
}

struct Rays {
  std::array<double, lanes> x{}, y{}, z{}, plane_x{}, plane_y{}, own_plane{};

  explicit Rays(std::span<const PacketLine> lines) {
    for (std::size_t k = 0; k < lanes; ++k) {
      const PacketLine& line = lines[std::min(k, lines.size() - 1)];
      x[k] = line.start.x, y[k] = line.start.y, z[k] = line.start.z;
      plane_x[k] = line.plane_ray.x, plane_y[k] = line.plane_ray.y;
      own_plane[k] = line.one_plane ? 0 : 1;
    }
  }
};

HWY_INLINE Real along(const Plane& octant, Real x, Real y) {
  const Real p = octant.swapped ? y : x;
  return octant.flip_p ? hn::Neg(p) : p;
}

HWY_INLINE void Rows::prepare(const PacketTask& task, std::span<PacketLine> lines) {
  const Rays rays(lines);
  const Plane& octant = task.octant;
  const Real x = hn::LoadU(d, rays.x.data()), y = hn::LoadU(d, rays.y.data()), z = hn::LoadU(d, rays.z.data());
  const Real plane_x = hn::LoadU(d, rays.plane_x.data()), plane_y = hn::LoadU(d, rays.plane_y.data());
  const Mask own_plane = hn::Gt(hn::LoadU(d, rays.own_plane.data()), hn::Zero(d));
  const Real step_x = real(task.step.x), step_y = real(task.step.y), step_z = real(task.step.z);
  const Real p0 = along(octant, x, y), p1 = along(octant, step_x, step_y);
  const Real zero = hn::Zero(d);
  Mask fits = hn::Eq(zero, zero);

  count_ = task.cuts.size() - 1;
  rows_.resize((count_ + 1) * lanes);
  Real last_m = zero, largest_turn = zero;
  const auto slope_at = [&](Real t) HWY_ATTR {
    const Real advance = larger(hn::Add(p0, hn::Mul(t, p1)), real(least_advance));
    return hn::Div(hn::Add(z, hn::Mul(t, step_z)), advance);
  };
  Real s1 = slope_at(real(task.cuts[0]));
  for (std::size_t i = 0; i < count_; ++i) {
    const Real t1 = real(task.cuts[i + 1]), middle = real((task.cuts[i] + task.cuts[i + 1]) / 2);
    const Real ray_x = hn::Add(x, hn::Mul(middle, step_x)), ray_y = hn::Add(y, hn::Mul(middle, step_y));
    const Real ray_z = hn::Add(z, hn::Mul(middle, step_z));
    const Real of_plane_x = hn::IfThenElse(own_plane, ray_x, plane_x);
    const Real of_plane_y = hn::IfThenElse(own_plane, ray_y, plane_y);
    const Real width_x = hn::Abs(of_plane_x), width_y = hn::Abs(of_plane_y);
    const Real minor = smaller(width_x, width_y), major = larger(width_x, width_y);
    const Real s0 = s1;
    s1 = slope_at(t1);

    const Real p = octant.swapped ? of_plane_y : of_plane_x, q = octant.swapped ? of_plane_x : of_plane_y;
    const Mask same_axis = octant.swapped ? hn::Gt(width_y, width_x) : hn::Not(hn::Gt(width_y, width_x));
    const Mask same_p = octant.flip_p ? hn::Lt(p, zero) : hn::Not(hn::Lt(p, zero));
    const Mask same_q = octant.flip_q ? hn::Lt(q, zero) : hn::Not(hn::Lt(q, zero));
    fits = hn::And(fits, hn::And(hn::And(same_axis, hn::Gt(major, zero)), hn::And(same_p, same_q)));
    // Rises along the line, on this side of the nadir; and not so level that places on the texture can not be told.
    fits = hn::And(fits, hn::And(hn::Le(s0, s1), hn::Ge(along(octant, ray_x, ray_y), zero)));
    if (task.interpolation != Interpolation::nearest) {
      fits = hn::And(fits, hn::Ge(hn::Abs(ray_z), real(1e-12)));
    }
    const Real m = hn::Div(minor, major);
    if (i > 0) largest_turn = hn::Max(largest_turn, hn::Abs(hn::Sub(m, last_m)));
    last_m = m;
    hn::StoreInterleaved4(m, s0, s1, t1, d, &rows_[i * lanes].m);
  }
  largest_turn_ = hn::GetLane(hn::MaxOfLanes(d, largest_turn));
  // Beyond the last row, in the same plane, nothing is higher than the ray, nor is the ray above the horizon.
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t k = 0; k < lanes; ++k) {
    rows_[count_ * lanes + k] = {rows_[(count_ - 1) * lanes + k].m, nothing, nothing, nothing};
  }

  for_each_lane(hn::Not(fits), [&](std::size_t k) {
    if (k < lines.size()) lines[k].fits = false;
  });
}

}  // namespace heightfield::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#endif
