// The walk of Cohen-Or 1997, Fig. 12, over many columns at once: Look::stretches and Walk::climb, seen from above all
// summits. In every step each lane looks at one voxel. What happens rarely (a lane enters another level) is done lane
// by lane by the walk itself.
#include "packet_lanes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "packet_lanes.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

#include "packet_cells.h"
#include "packet_rows.h"
#include "packet_vectors.h"

HWY_BEFORE_NAMESPACE();

namespace heightfield::HWY_NAMESPACE {

// `index` or, where that lies without 0 .. period - 1, the one a period away.
HWY_INLINE Int wrapped_down(Int index, Int period) {
  constexpr hn::Rebind<std::uint32_t, D> u;
  return hn::BitCast(I(), hn::Min(hn::BitCast(u, index), hn::BitCast(u, hn::Sub(index, period))));
}
HWY_INLINE Int wrapped_up(Int index, Int period) {
  constexpr hn::Rebind<std::uint32_t, D> u;
  return hn::BitCast(I(), hn::Min(hn::BitCast(u, index), hn::BitCast(u, hn::Add(index, period))));
}
// The voxel that an index of a mirrored map shows. Requires: reduced to one period.
HWY_INLINE Int folded(Int index, Int period) {
  return hn::Min(index, hn::Sub(hn::Sub(period, hn::Set(I(), 1)), index));
}

// Lanes side by side.
template <Interpolation interpolation>
class Packet {
 public:
  // False if none of the lines fits.
  bool begin(const PacketTask& task, const Rows& rows, std::span<const PacketLine> lines);
  // Walks until the last row of every lane is seen.
  void walk();
  // Hands over what the rows have seen.
  void finish(moire::Tally& pieces) const;

 private:
  // What changes from step to step. The walk has a copy of its own, for the compiler to keep in registers.
  struct State {
    Real p;                              // voxel of the leg's level
    Int at_p, at_q, laps_q;              // reduced to one mirror period, and what was taken away from q
    Real m, scaled_m;                    // of the row's plane; the same in voxels of the leg's level
    Real slope, last_slope, at, end_at;  // of the rays, and along the line, where the row is seen so far and ends
    Real weight, r, g, b;                // sums of the row
    Real last_hit;                       // p of the last voxel met
    std::uint64_t hits;
  };

  void step(State& state);
  void end_rows(State& state, Mask ended);
  void find_end(State& state, Mask changed, Real m);
  void pass_over(State& state);
  void pass_hidden(State& state, Mask waiting) const;
  void load_leg(State& state, std::size_t k);
  void look_ahead(const State& state);
  // Where the cells of these places lie in their level. Requires: both reduced to one mirror period.
  HWY_INLINE Int places(Int p, Int q) const {
    const Int at_p = folded(p, period_p_), at_q = folded(q, period_q_);
    const Int row = swapped_ ? at_p : at_q, column = swapped_ ? at_q : at_p;
    return hn::Add(hn::Mul(row, row_width_), column);
  }
  void count_laps(State& state);
  // Of each lane's row.
  HWY_INLINE RowFields<Real> row_fields() const {
    alignas(64) std::array<std::int64_t, lanes> places;
    hn::Store(place_, W(), places.data());
    std::array<const Row*, lanes> rows;
    for (std::size_t k = 0; k < lanes; ++k) rows[k] = rows_ + places[k];
    return load_rows(d, rows.data());
  }
  static HWY_INLINE void add(State& state, Real weight, Real r, Real g, Real b) {
    state.weight = hn::Add(state.weight, weight);
    state.r = hn::Add(state.r, hn::Mul(weight, r));
    state.g = hn::Add(state.g, hn::Mul(weight, g));
    state.b = hn::Add(state.b, hn::Mul(weight, b));
  }
  HWY_INLINE void advance(State& state, Real by) const {
    state.p = hn::Add(state.p, by);
    state.at_p = wrapped_down(hn::Add(state.at_p, hn::DemoteTo(I(), by)), period_p_);
  }
  HWY_INLINE void deposit(State& state, Real weight, const Cells& cells, Real p, Real q, Real x1);

  // Of all lanes.
  const PacketTask* task_ = nullptr;
  const Row* rows_ = nullptr;
  std::vector<moire::Tally::Sum> sums_;  // row after row, lane after lane
  bool unhit_ = true;                    // some lane has seen no voxel in the rows behind it
  bool turns_far_ = false;               // a row's first voxel may lie a mirror period aside of the last one's, or more
  std::size_t row_count_ = 0;
  std::span<const PacketLine> lines_;
  bool swapped_ = false;
  double z_ = 0, eye_p_ = 0;
  std::ptrdiff_t ahead_ = 0;  // from a cell to the one some steps ahead, as far as the first lane can tell
  State state_{};

  // Of the row, by lane.
  hn::Vec<W> place_;  // of the lane's row in rows_ and sums_
  // Of the leg.
  Real live_, end_, stop_, eye_q_, width_, half_width_, inverse_width_, end_of_level_, sure_end_, step_place_;
  Real shift_q_, inset_;  // what was taken away from eye_q_, and what a place in a voxel keeps off its sides
  Real first_hit_, line_p0_, line_p1_, line_z_, line_dz_;
  Int period_p_, period_q_, row_width_;
  std::array<const Cell*, lanes> cells_{};
  std::array<const Summits*, lanes> summits_{};
  std::vector<Walk<false>> walks_;
};

template <Interpolation interpolation>
HWY_INLINE bool Packet<interpolation>::begin(const PacketTask& task, const Rows& rows,
                                             std::span<const PacketLine> lines) {
  task_ = &task;
  rows_ = rows.data();
  row_count_ = rows.count();
  lines_ = lines;
  sums_.resize((row_count_ + 1) * lanes);
  swapped_ = task.octant.swapped;
  z_ = task.view.z;
  State& state = state_;
  state.hits = 0;
  unhit_ = true;
  const Voxels::Level& finest = task.view.voxels->level(0);
  const double reach = task.view.far / std::min(task.view.spacing_x, task.view.spacing_y);
  const int period_q = swapped_ ? finest.column_period() : finest.row_period();
  turns_far_ = rows.largest_turn() * reach + 1 > period_q / 2.0;
  const Real zero = hn::Zero(d);
  state.weight = state.r = state.g = state.b = zero;
  step_place_ = zero;
  first_hit_ = state.last_hit = real(-infinity);
  const Rays rays(lines);
  line_p0_ = along(task.octant, hn::LoadU(d, rays.x.data()), hn::LoadU(d, rays.y.data()));
  line_p1_ = along(task.octant, real(task.step.x), real(task.step.y));
  line_z_ = hn::LoadU(d, rays.z.data());
  line_dz_ = real(task.step.z);

  std::array<double, lanes> live{};
  std::array<std::int64_t, lanes> places{};
  for (std::size_t k = 0; k < lanes; ++k) {
    const bool walks = k < lines.size() && lines[k].fits;
    live[k] = walks ? 1 : 0;
    places[k] = static_cast<std::int64_t>(walks ? k : row_count_ * lanes + k);
  }
  live_ = hn::LoadU(d, live.data());
  place_ = hn::LoadU(W(), places.data());
  if (std::find(live.begin(), live.end(), 1) == live.end()) return false;
  state.at = real(task.cuts[0]);
  const auto row = row_fields();
  state.m = row.m;
  state.slope = row.first_slope;
  state.last_slope = row.last_slope;
  state.end_at = row.end;

  // Lanes without a line stand where the first one does, and go nowhere.
  walks_.clear();
  const auto first = static_cast<std::size_t>(
      std::find_if(lines.begin(), lines.end(), [](const PacketLine& line) { return line.fits; }) - lines.begin());
  for (std::size_t k = 0; k < lanes; ++k) {
    const std::size_t like = live[k] > 0 ? k : first;
    Plane plane = task.octant;
    plane.m = rows_[like].m;
    walks_.emplace_back(task.view);
    walks_.back().start(plane, rows_[like].first_slope);
    load_leg(state, k);
  }
  return true;
}

template <Interpolation interpolation>
void Packet<interpolation>::walk() {
  // Looking for hidden runs at every step would cost more than it saves.
  constexpr int steps_between = 8;
  const bool skips = task_->view.skip != Skip::nowhere;
  const Real patience = real(static_cast<double>(task_->view.patience()));
  State state = state_;
  while (!hn::AllTrue(d, hn::IsNaN(state.slope))) {
    look_ahead(state);
    for (int k = 0; k < steps_between; ++k) step(state);
    if (!skips) continue;
    const Mask sinks = hn::Lt(state.slope, hn::Zero(d));
    const Mask waiting = hn::And(sinks, hn::Gt(hn::Sub(state.p, state.last_hit), patience));
    if (HWY_LIKELY(hn::AllFalse(d, waiting))) continue;
    State behind = state;
    pass_hidden(behind, waiting);
    state = behind;
  }
  state_ = state;
}

// Cells are fetched some steps before they are looked at: no cache holds a large map. Where to is taken from the first
// lane, which mirrored or not goes on in rows and columns as its neighbours do; being wrong costs time only.
template <Interpolation interpolation>
HWY_INLINE void Packet<interpolation>::look_ahead(const State& state) {
  const int row_width = hn::GetLane(row_width_);
  const auto forward = [](int at, int period, int stride) { return at < period / 2 ? stride : -stride; };
  const int to_p = forward(hn::GetLane(state.at_p), hn::GetLane(period_p_), swapped_ ? row_width : 1);
  const int to_q = forward(hn::GetLane(state.at_q), hn::GetLane(period_q_), swapped_ ? 1 : row_width);
  const int aside = static_cast<int>(steps_ahead * hn::GetLane(state.m));
  ahead_ = static_cast<std::ptrdiff_t>(sizeof(Cell)) * (steps_ahead * to_p + aside * to_q);
}

// Takes over what the lane's own walk knows of the leg that lies ahead.
template <Interpolation interpolation>
HWY_NOINLINE void Packet<interpolation>::load_leg(State& state, std::size_t k) {
  const Walk<false>::Leg leg = walks_[k].leg();
  const Voxels::Level& level = task_->view.voxels->level(leg.level);
  const double inverse_width = std::ldexp(1.0, -leg.level);
  eye_p_ = leg.eye_p;
  set_lane(state.p, k, leg.p);
  set_lane(end_, k, leg.end);
  set_lane(end_of_level_, k, leg.end_of_level);
  set_lane(stop_, k, leg.stop);
  set_lane(sure_end_, k, leg.sure_end);
  set_lane(state.last_hit, k, lane(state.last_hit, k) + lane(step_place_, k) - leg.place);
  set_lane(step_place_, k, leg.place);
  set_lane(width_, k, std::ldexp(1.0, leg.level));
  set_lane(half_width_, k, std::ldexp(0.5, leg.level));
  set_lane(inverse_width_, k, inverse_width);
  set_lane(inset_, k, lane(width_, k) * 1e-9);
  set_lane(shift_q_, k, static_cast<double>(leg.shift_q) * inverse_width);
  set_lane(eye_q_, k, leg.eye_q * inverse_width);
  set_lane(state.scaled_m, k, lane(state.m, k) * inverse_width);
  const int period_p = swapped_ ? level.row_period() : level.column_period();
  const int period_q = swapped_ ? level.column_period() : level.row_period();
  set_lane(period_p_, k, period_p);
  set_lane(period_q_, k, period_q);
  set_lane(state.at_p, k, static_cast<std::int64_t>(leg.p) % period_p);
  const double x = std::max((leg.p + 0.5) * lane(width_, k) - leg.eye_p, 0.0);
  const auto q = static_cast<std::int64_t>((leg.eye_q + x * lane(state.m, k)) * inverse_width);
  set_lane(state.at_q, k, q % period_q);
  set_lane(state.laps_q, k, q - q % period_q);
  set_lane(row_width_, k, level.width);
  cells_[k] = level.cells.data();
  summits_[k] = &level.summits;
}

// Walk::find_end for lanes whose plane has changed where the far limit is near.
template <Interpolation interpolation>
HWY_NOINLINE void Packet<interpolation>::find_end(State& state, Mask changed, Real m) {
  const View& view = task_->view;
  const Real spacing_p = real(swapped_ ? view.spacing_y : view.spacing_x);
  const Real spacing_q = real(swapped_ ? view.spacing_x : view.spacing_y);
  const Real unit =
      hn::Sqrt(hn::Add(hn::Mul(spacing_p, spacing_p), hn::Mul(hn::Mul(hn::Mul(m, m), spacing_q), spacing_q)));
  const Mask stopped = hn::Ge(state.p, end_), sure = hn::Lt(state.p, sure_end_);
  const Real limit = hn::Div(real(view.far), unit);
  const Real stop = hn::IfThenElse(sure, real(infinity), limit);
  const Real limit_end = hn::Ceil(hn::Mul(hn::Add(real(eye_p_), limit), inverse_width_));
  const Real end = smaller(end_of_level_, hn::IfThenElse(sure, sure_end_, limit_end));
  const Mask gained = hn::And(changed, hn::And(stopped, hn::Gt(stop, stop_)));
  stop_ = hn::IfThenElse(changed, stop, stop_);
  end_ = hn::IfThenElse(changed, end, end_);
  const Real back = hn::IfThenElseZero(gained, real(1));
  state.p = hn::Sub(state.p, back);
  state.at_p = wrapped_up(hn::Sub(state.at_p, hn::DemoteTo(I(), back)), period_p_);
}

// Walk::behind_hidden, from block to block.
template <Interpolation interpolation>
HWY_NOINLINE void Packet<interpolation>::pass_hidden(State& state, Mask waiting) const {
  for_each_lane(waiting, [&](std::size_t k) {
    const double width = lane(width_, k), stop = lane(stop_, k), eye_q = lane(eye_q_, k), m = lane(state.scaled_m, k);
    const double slope = lane(state.slope, k), end = lane(end_, k);
    const int period_p = lane(period_p_, k), period_q = lane(period_q_, k);
    const auto q_at = [&](double x) { return static_cast<std::int32_t>(eye_q + std::max(x, 0.0) * m); };
    double p = lane(state.p, k);
    int at_p = lane(state.at_p, k);
    const double stood = p;
    while (p < end) {
      const int length = summits_[k]->length(swapped_, at_p);
      const double run_end = std::min(end, p + length);
      const double x1 = std::min(run_end * width - eye_p_, stop);
      const std::int32_t q = q_at(p * width - eye_p_), aside = q_at(x1) - q;
      if (summits_[k]->highest({swapped_, at_p, q % period_q, aside}) - z_ > slope * x1) break;
      at_p = (at_p + static_cast<int>(run_end - p)) % period_p;
      p = run_end;
    }
    if (p == stood) return;
    const std::int32_t q = q_at((p + 0.5) * width - eye_p_);
    set_lane(state.p, k, p);
    set_lane(state.at_p, k, at_p);
    set_lane(state.laps_q, k, q - q % period_q);
  });
}

// Finds anew how many mirror periods aside of the eye the lanes stand.
template <Interpolation interpolation>
HWY_NOINLINE void Packet<interpolation>::count_laps(State& state) {
  for (std::size_t k = 0; k < lanes; ++k) {
    const double x = std::max((lane(state.p, k) + 0.5) * lane(width_, k) - eye_p_, 0.0);
    const auto q = static_cast<std::int32_t>(lane(eye_q_, k) + x * lane(state.scaled_m, k));
    set_lane(state.laps_q, k, q - q % lane(period_q_, k));
  }
}

// Goes on to the next row in these lanes.
template <Interpolation interpolation>
HWY_INLINE void Packet<interpolation>::end_rows(State& state, Mask ended) {
  // The sums of all lanes: those whose row goes on are written again.
  alignas(64) std::array<moire::Tally::Sum, lanes> sums;
  alignas(64) std::array<std::int64_t, lanes> places;
  hn::StoreInterleaved4(state.weight, state.r, state.g, state.b, d, &sums[0].weight);
  hn::Store(place_, W(), places.data());
  for (std::size_t k = 0; k < lanes; ++k) sums_[static_cast<std::size_t>(places[k])] = sums[k];
  state.weight = hn::IfThenZeroElse(ended, state.weight);
  state.r = hn::IfThenZeroElse(ended, state.r);
  state.g = hn::IfThenZeroElse(ended, state.g);
  state.b = hn::IfThenZeroElse(ended, state.b);
  if (unhit_) {
    const Mask unhit = hn::Lt(first_hit_, hn::Zero(d));
    first_hit_ = hn::IfThenElse(hn::And(ended, unhit), hn::Add(state.last_hit, step_place_), first_hit_);
    unhit_ = !hn::AllFalse(d, hn::Lt(first_hit_, hn::Zero(d)));
  }

  place_ = hn::Add(place_, hn::IfThenElseZero(hn::RebindMask(W(), ended), hn::Set(W(), lanes)));
  const auto row = row_fields();
  const Real m = row.m;
  state.slope = hn::IfThenElse(ended, row.first_slope, state.slope);
  live_ = hn::IfThenZeroElse(hn::IsNaN(state.slope), live_);
  state.last_slope = row.last_slope;
  state.end_at = row.end;
  const Mask near_limit = hn::And(hn::And(ended, hn::Lt(stop_, real(infinity))), hn::Ne(m, state.m));
  state.m = m;
  state.scaled_m = hn::Mul(m, inverse_width_);
  if (HWY_UNLIKELY(turns_far_ || !hn::AllFalse(d, near_limit))) {
    State moved = state;
    find_end(moved, near_limit, m);
    if (turns_far_) count_laps(moved);
    state = moved;
  }
}

// Lets lanes that stand at the end of their leg enter the next one, and gives the sky its due in those that see no more
// terrain in their row.
template <Interpolation interpolation>
HWY_NOINLINE void Packet<interpolation>::pass_over(State& state) {
  const Real zero = hn::Zero(d);
  bool turned = false;
  for (;;) {
    // Above the horizon no terrain is left. Beyond the last row the slope is no number.
    const Mask above = hn::Ge(state.slope, zero);
    end_ = hn::IfThenElse(hn::IsNaN(state.slope), real(infinity), end_);
    const Mask at_end = hn::Ge(state.p, end_);
    Mask sky = hn::Or(above, hn::And(at_end, hn::And(hn::Lt(stop_, real(infinity)), hn::Lt(end_, end_of_level_))));
    const Mask leg_ends = hn::AndNot(sky, at_end);
    if (hn::AllFalse(d, leg_ends) && hn::AllFalse(d, sky)) break;
    for_each_lane(leg_ends, [&](std::size_t k) {
      Walk<false>::Leg leg{};
      leg.p = lane(state.p, k), leg.end = lane(end_, k), leg.stop = lane(stop_, k);
      const bool goes_on = walks_[k].next_leg(leg, lane(state.m, k));
      load_leg(state, k);
      if (!goes_on) set_lane(end_, k, lane(state.p, k));
    });
    sky = hn::Or(sky, hn::And(leg_ends, hn::Ge(state.p, end_)));
    if (hn::AllFalse(d, sky)) continue;
    const Real until = hn::IfThenElse(sky, state.end_at, state.at);
    const Real weight = hn::Sub(until, state.at);
    state.at = until;
    add(state, weight, real(task_->sky.r), real(task_->sky.g), real(task_->sky.b));
    end_rows(state, sky);
    turned = true;
  }
  // Row after row of sky has turned the plane, and no step has kept count.
  if (turned) count_laps(state);
}

template <Interpolation interpolation>
HWY_INLINE void Packet<interpolation>::deposit(State& state, Real weight, const Cells& cells, Real p, Real q, Real x1) {
  if constexpr (interpolation == Interpolation::nearest) {
    (void)p, (void)q, (void)x1;
    add(state, weight, cells.r, cells.g, cells.b);
  } else {
    // Look::surface_point in the middle of the voxel, along the axis across the walk.
    const bool flip = task_->octant.flip_q;
    const Real x0 = larger(hn::Sub(hn::Mul(p, width_), real(eye_p_)), hn::Zero(d));
    const Real middle = hn::Div(hn::Add(x0, x1), real(2));
    const Real aside = hn::Mul(middle, state.m);
    const Real eye = real(swapped_ ? task_->view.x : task_->view.y);
    const Real unreduced = hn::Add(q, shift_q_);
    const Real texel = flip ? hn::Sub(real(-1), unreduced) : unreduced;
    const Real low = hn::Mul(texel, width_);
    const Real first = hn::Add(low, inset_), last = hn::Sub(hn::Add(low, width_), inset_);
    const Real place = smaller(larger(hn::Add(eye, flip ? hn::Neg(aside) : aside), first), last);
    // moire::LinearAcross: between the middles of two texels.
    const Real between = hn::Sub(hn::Mul(place, inverse_width_), real(0.5));
    const Real whole = hn::Floor(between), fraction = hn::Sub(between, whole);
    const Mask own_first = hn::Eq(whole, texel);
    const Real aside_by = hn::IfThenElse(own_first, real(flip ? -1 : 1), real(flip ? 1 : -1));
    const Int other_q = hn::Add(state.at_q, hn::DemoteTo(I(), aside_by));
    const Int other_places = places(state.at_p, wrapped_down(wrapped_up(other_q, period_q_), period_q_));
    std::array<std::int32_t, lanes> indices;
    hn::StoreU(other_places, I(), indices.data());
    std::array<const Cell*, lanes> others;
    for (std::size_t k = 0; k < lanes; ++k) others[k] = cells_[k] + indices[k];
    const Cells other = load_cells(d, others.data());
    const auto pick = [&](Real own, Real neighbour, bool first_one) HWY_ATTR {
      return (first_one ? hn::IfThenElse(own_first, own, neighbour) : hn::IfThenElse(own_first, neighbour, own));
    };
    add(state, hn::Mul(weight, hn::Sub(real(1), fraction)), pick(cells.r, other.r, true), pick(cells.g, other.g, true),
        pick(cells.b, other.b, true));
    add(state, hn::Mul(weight, fraction), pick(cells.r, other.r, false), pick(cells.g, other.g, false),
        pick(cells.b, other.b, false));
  }
}

// Looks at one voxel in every lane.
template <Interpolation interpolation>
HWY_INLINE void Packet<interpolation>::step(State& state) {
  const Real zero = hn::Zero(d);
  if (HWY_UNLIKELY(!hn::AllFalse(d, hn::Or(hn::Ge(state.p, end_), hn::Ge(state.slope, zero))))) {
    State passed = state;
    pass_over(passed);
    state = passed;
  }

  const Real p = state.p, eye_p = real(eye_p_);
  const Real next = hn::Mul(hn::Add(p, real(1)), width_);
  const Real from_eye = hn::Sub(next, eye_p);
  const Real x1 = smaller(from_eye, stop_);
  const Real middle = hn::Sub(hn::Sub(next, half_width_), eye_p);
  const Real q = hn::Add(eye_q_, hn::Mul(larger(middle, zero), state.scaled_m));
  // q within a period of where it was last.
  const Int whole_q = hn::DemoteTo(I(), q);
  const Int near_q = hn::Sub(whole_q, state.laps_q);
  state.at_q = wrapped_down(wrapped_up(near_q, period_q_), period_q_);
  state.laps_q = hn::Sub(whole_q, state.at_q);

  std::array<std::int32_t, lanes> indices;
  hn::StoreU(places(state.at_p, state.at_q), I(), indices.data());
  std::array<const Cell*, lanes> cells;
  for (std::size_t k = 0; k < lanes; ++k) {
    cells[k] = cells_[k] + indices[k];
    __builtin_prefetch(reinterpret_cast<const char*>(cells[k]) + ahead_);
  }
  const Cells cell = load_cells(d, cells.data());

  const Real top = hn::Sub(cell.height, real(z_));
  const Mask met = hn::Gt(top, hn::Mul(state.slope, x1));
  const Mask ends = hn::And(met, hn::Ge(top, hn::Mul(state.last_slope, x1)));
  state.hits += hn::CountTrue(d, met);
  // The image of the far edge of the box's top.
  const Real edge = hn::Div(hn::Sub(hn::Mul(top, line_p0_), hn::Mul(line_z_, x1)),
                            hn::Sub(hn::Mul(line_dz_, x1), hn::Mul(top, line_p1_)));
  Real until = smaller(larger(edge, state.at), state.end_at);
  until = hn::IfThenElse(met, hn::IfThenElse(ends, state.end_at, until), state.at);
  deposit(state, hn::Sub(until, state.at), cell, p, hn::Trunc(q), x1);
  state.at = until;
  state.slope = hn::IfThenElse(met, smaller(hn::Div(top, x1), state.last_slope), state.slope);
  state.last_hit = hn::IfThenElse(met, p, state.last_hit);
  // Two ways, so that while no row ends the next voxels are found and fetched before this one is compared.
  if (hn::AllFalse(d, ends)) {
    advance(state, live_);
  } else {
    advance(state, hn::IfThenZeroElse(ends, live_));
    end_rows(state, ends);
  }
}

template <Interpolation interpolation>
HWY_INLINE void Packet<interpolation>::finish(moire::Tally& pieces) const {
  const moire::Tally::Adder<false> add(pieces);
  pieces.counters.hits += state_.hits;
  std::array<std::size_t, lanes> slots{};
  std::array<std::size_t, lanes> fitting{};
  std::size_t count = 0;
  for (std::size_t k = 0; k < lines_.size(); ++k) {
    if (!lines_[k].fits) continue;
    slots[count] = lines_[k].first_slot;
    fitting[count++] = k;
  }
  // Sums lie row by row.
  for (std::size_t i = 0; i < row_count_; ++i) {
    for (std::size_t n = 0; n < count; ++n) add.sum(slots[n] + i, sums_[i * lanes + fitting[n]]);
  }
  pieces.counters.queries += row_count_ * count;
  for (std::size_t n = 0; n < count; ++n) {
    const std::size_t k = fitting[n];
    const double first = lane(first_hit_, k), last = lane(hn::Add(state_.last_hit, step_place_), k);
    if (first >= 0) pieces.counters.steps += 1 + static_cast<std::uint64_t>(last - first);
  }
}

template <Interpolation interpolation>
HWY_INLINE void follow_as(const PacketTask& task, std::span<PacketLine> lines, moire::Tally& pieces) {
  Rows rows;
  Packet<interpolation> packet;
  for (std::size_t first = 0; first < lines.size(); first += lanes) {
    const std::span<PacketLine> some = lines.subspan(first, std::min(lanes, lines.size() - first));
    rows.prepare(task, some);
    if (!packet.begin(task, rows, some)) continue;
    packet.walk();
    packet.finish(pieces);
  }
}

void follow(const PacketTask& task, std::span<PacketLine> lines, moire::Tally& pieces) {
  if (task.interpolation == Interpolation::nearest) {
    follow_as<Interpolation::nearest>(task, lines, pieces);
  } else {
    follow_as<Interpolation::linear_across>(task, lines, pieces);
  }
}

std::size_t lane_count() { return lanes; }

}  // namespace heightfield::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace heightfield {

HWY_EXPORT(follow);
HWY_EXPORT(lane_count);

void follow(const PacketTask& task, std::span<PacketLine> lines, moire::Tally& pieces) {
  HWY_DYNAMIC_DISPATCH(follow)(task, lines, pieces);
}

std::size_t lanes_of_packets() { return HWY_DYNAMIC_DISPATCH(lane_count)(); }

}  // namespace heightfield

#endif
