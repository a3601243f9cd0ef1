// The horizon of a wedge of directions while chains (the upper edges of boxes) are laid before it, row by row.
//
// For every azimuth u the directions already seen are all those below one height v, so the horizon is a piecewise
// linear function of u, with upright steps. Chains of a row come from u0 outward, each before the next: they overlap
// only in the stretch where a ray passes from one voxel to its neighbour. What a chain shows is what lies between it
// and the horizon, and goes to `show` as polygons.
#pragma once

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "exact/projection.h"

namespace heightfield::exact {

// show(std::span<const Vertex>): the corners of a visible piece.
template <class Show>
class Skyline {
 public:
  Skyline(const Projection& projection, const Wedge& wedge, Show show)
      : projection_(projection), u0_(wedge.u0), u1_(wedge.u1), show_(show) {
    reserve(2);
    new_[0] = projection.vertex(u0_, bottomless);
    new_[1] = projection.vertex(u1_, bottomless);
    out_ = new_.data() + 2;
  }

  Show& show() { return show_; }

  // No less is the horizon's height anywhere, as long as it only rises.
  double lowest() const {
    double lowest = new_[0].v;
    for (const Vertex* vertex = new_.data(); vertex != out_; ++vertex) lowest = std::min(lowest, vertex->v);
    return lowest;
  }

  // A row with no more than so many pieces of chains.
  void begin_row(std::size_t pieces) {
    reserve(2 * static_cast<std::size_t>(out_ - new_.data()) + 8 * pieces + 16);
    std::swap(old_, new_);
    next_ = old_.data() + 1;
    while (next_->u == u0_) ++next_;
    out_ = new_.data();
    *out_++ = next_[-1];
    u_ = u0_;
    front_ = next_[-1].v;
    branch_ = branch_end_ = nullptr;
  }
  void end_row() {
    if (out_[-1].u < u1_) *out_++ = projection_.vertex(u1_, front_);
  }

  double u() const { return u_; }
  bool visible() const { return visible_; }

  // The chain begins here, at the height v.
  void begin_chain(double v) {
    chain_ = v;
    visible_ = v > front_;
    if (!visible_) return;
    Vertex foot = out_[-1];
    if (foot.u != u_ || foot.v != front_) *out_++ = foot = projection_.vertex(u_, front_);
    const Vertex top = projection_.vertex(u_, v);
    *out_++ = top;
    open(foot);
    *--upper_ = top;
  }
  // It ends here.
  void end_chain() {
    if (!visible_) return;
    const Vertex top = projection_.vertex(u_, chain_), foot = projection_.vertex(u_, front_);
    *out_++ = top;
    *out_++ = foot;
    *--upper_ = top;
    close(foot);
  }
  // It has a corner here.
  void bend() {
    if (!visible_) return;
    const Vertex corner = projection_.vertex(u_, chain_);
    *out_++ = corner;
    *--upper_ = corner;
  }

  // The chain goes on straight to (u, v).
  [[gnu::always_inline]] void follow(double u, double v) {
    const Line chain = line_to(u, v);
    for (; next_->u < u; ++next_) pass(*next_, chain.at(next_->u));
    step(u, height_before(next_, u), v);
  }
  // No chain as far as u.
  void skip(double u) {
    for (; next_->u < u; ++next_) *out_++ = *next_;
    stand(u, height_before(next_, u));
  }

  // From here on the next chain lies behind this one: what the horizon becomes is what that one finds.
  void fork() {
    fork_u_ = u_;
    fork_front_ = visible_ ? chain_ : front_;
    main_ = out_;
    branch_ = branch_store_.data();
    branch_[0] = visible_ ? Vertex{u_, chain_, {}} : next_[-1];
    out_ = ++branch_;
  }
  // Back to where the horizon forked; the next chain begins.
  void rejoin() {
    *out_ = {u_, front_, {}};
    branch_end_ = out_;
    out_ = main_;
    u_ = fork_u_;
    front_ = fork_front_;
  }
  // follow() and skip() over what the last chain left. Requires: no farther than to where that one ended.
  [[gnu::always_inline]] void follow_branch(double u, double v) {
    const Line chain = line_to(u, v);
    for (; is_before(u); ++branch_) pass(*branch_, chain.at(branch_->u));
    step(u, height_in_branch(u), v);
  }
  void skip_branch(double u) {
    for (; is_before(u); ++branch_) *out_++ = *branch_;
    stand(u, height_in_branch(u));
  }

 private:
  // As good as straight down.
  static constexpr double bottomless = -1e30;

  struct Line {
    double u, v, slope;
    double at(double where) const { return v + slope * (where - u); }
  };
  Line line_to(double u, double v) const { return {u_, chain_, u > u_ ? (v - chain_) / (u - u_) : 0}; }

  static double height_before(const Vertex* next, double u) {
    const Vertex &a = next[-1], &b = next[0];
    return a.v == b.v ? a.v : a.v + (u - a.u) / (b.u - a.u) * (b.v - a.v);
  }

  void reserve(std::size_t vertices) {
    if (vertices <= new_.size()) return;
    const auto used = out_ - new_.data();
    for (std::vector<Vertex>* store : {&old_, &new_, &branch_store_}) store->resize(2 * vertices);
    out_ = new_.data() + used;
    outline_.resize(8 * vertices);
  }

  // The branch's last vertices may stand where it ends.
  bool is_before(double u) const { return branch_ != branch_end_ && (branch_->u < u || u == branch_end_->u); }
  double height_in_branch(double u) const { return u == branch_end_->u ? branch_end_->v : height_before(branch_, u); }

  void stand(double u, double front) {
    u_ = u;
    front_ = front;
  }
  // Goes on to a vertex of the horizon, where the chain is at that height.
  [[gnu::always_inline]] void pass(const Vertex& vertex, double chain) {
    step(vertex.u, vertex.v, chain);
    *(visible_ ? lower_ : out_)++ = vertex;
  }
  // Horizon and chain are straight from here to u.
  [[gnu::always_inline]] void step(double u, double front, double chain) {
    const double before = chain_ - front_, after = chain - front;
    if ((after > 0) != visible_) {
      const double t = before / (before - after);
      const Vertex crossing = projection_.vertex(std::min(u_ + t * (u - u_), u), chain_ + t * (chain - chain_));
      *out_++ = crossing;
      if (visible_) {
        close(crossing);
      } else {
        open(crossing);
      }
    }
    stand(u, front);
    chain_ = chain;
  }

  // The outline of a visible piece grows from the middle of its store: its upper edge downward, its lower one upward.
  void open(const Vertex& vertex) {
    visible_ = true;
    lower_ = upper_ = outline_.data() + outline_.size() / 2;
    *lower_++ = vertex;
  }
  void close(const Vertex& vertex) {
    visible_ = false;
    *lower_++ = vertex;
    show_(std::span<const Vertex>(upper_, lower_));
  }

  const Projection& projection_;
  double u0_, u1_;
  Show show_;
  std::vector<Vertex> old_, new_;     // the horizon before and after this row
  std::vector<Vertex> branch_store_;  // what the last chain made of it, where the next one overlaps
  std::vector<Vertex> outline_;
  Vertex *next_ = nullptr, *out_ = nullptr, *main_ = nullptr, *branch_ = nullptr, *branch_end_ = nullptr;
  Vertex *lower_ = nullptr, *upper_ = nullptr;
  double u_ = 0, front_ = 0, chain_ = 0;  // where the row stands: heights of the horizon and of the chain
  bool visible_ = false;                  // the chain is above the horizon
  double fork_u_ = 0, fork_front_ = 0;
};

}  // namespace heightfield::exact
