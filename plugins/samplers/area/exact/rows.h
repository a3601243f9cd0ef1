// A scanline sweep that finds what is visible exactly: for each row of pixels the boundaries between visible layers,
// and between them the layer that fills the row from top to bottom.
//
// The chains of a row are sorted by their left ends. Those whose x ranges do not touch any other's only have to be
// counted; where ranges touch, a Cluster finds what is visible.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "exact/chains.h"
#include "exact/cluster.h"
#include "exact/cover.h"
#include "exact/path.h"

namespace area {

// `Sink` gets, for each row from left to right:
//   begin_row(y);
//   open(left, front) before the boundaries of a cluster that begins at `left`; `front` fills the row from the cluster
//     before it up to there;
//   boundary(x0, y0, x1, y1, left layer, right layer, source), y in 0 .. 1 from the row's top, y0 < y1;
//   close(right) behind a cluster;
//   end_row(front), which fills the rest of the row.
template <class Sink>
class Rows {
 public:
  Rows(const Layers& layers, const Chains& chains, double right, Sink& sink)
      : layers_(layers),
        chains_(chains),
        right_(right),
        sink_(sink),
        winding_(layers.size(), 0),
        cover_(static_cast<std::uint32_t>(layers.size())),
        cluster_(layers) {}

  void sweep(int first, int end) {
    RowBuckets::for_each(first, end,
                         [&](int bucket, int begin, int stop) { sweep(chains_.buckets()[bucket], begin, stop); });
  }

 private:
  void sweep(std::span<const std::uint32_t> bucket, int first, int end) {
    active_.clear();
    free_.clear();
    order_.clear();
    std::size_t next = 0;
    for (int y = first; y < end; ++y) {
      for (; next < bucket.size() && chains_.points()[chains_[bucket[next]].first].y < y + 1; ++next)
        enter(chains_[bucket[next]], y);
      row(y);
    }
  }

  static constexpr std::uint32_t ended = std::numeric_limits<std::uint32_t>::max();

  struct Active {
    double left, right;         // of the row
    double x;                   // where it enters the row, if it does so from above
    std::uint32_t point, last;  // of its chain: where the segment that enters the row begins, and the end
    std::uint32_t layer;
    int direction;
    std::uint32_t path, segments;  // in the row
    bool has_level;                // in the row
  };

  // Where a strand stands among the others: by its left end.
  struct Place {
    double left;
    std::uint32_t last, active;  // the end of its chain, which tells equal ends apart; its place in active_
  };

  void enter(const Chain& chain, int y) {
    const moire::Point* p = chains_.points();
    const moire::Point* after = std::upper_bound(p + chain.first, p + chain.last + 1, static_cast<double>(y),
                                                 [](double top, const moire::Point& q) { return top < q.y; });
    if (after == p + chain.last + 1) return;
    const auto point = std::max(chain.first + 1, static_cast<std::uint32_t>(after - p)) - 1;
    const double x = p[point].y < y ? x_at(p[point], p[point + 1], y) : p[point].x;
    const Active active{0, 0, x, point, chain.last, chain.layer, chain.direction, 0, 0, false};
    if (free_.empty()) {
      order_.push_back({0, chain.last, static_cast<std::uint32_t>(active_.size())});
      active_.push_back(active);
    } else {
      order_.push_back({0, chain.last, free_.back()});
      active_[free_.back()] = active;
      free_.pop_back();
    }
  }

  // Appends to path_, which keeps its size from row to row.
  void extend(const PathPoint& point) {
    if (used_ == path_.size()) path_.resize(2 * path_.size() + 64);
    path_[used_++] = point;
  }

  // Finds the strand of a chain in row y.
  void trace(Active& a, int y) {
    const moire::Point* p = chains_.points();
    const double top = y, bottom = y + 1;
    a.path = used_;
    a.has_level = false;
    // Most go through without a bend.
    if (p[a.point].y <= top && p[a.point + 1].y > bottom) {
      const double x = x_at(p[a.point], p[a.point + 1], bottom);
      extend({a.x, 0, a.point});
      extend({x, 1, a.point});
      a.segments = 1;
      a.left = std::min(a.x, x);
      a.right = std::max(a.x, x);
      a.x = x;
      return;
    }
    const double start = p[a.point].y > top ? p[a.point].y - top : 0;
    extend({a.x, start, a.point});
    a.left = a.right = a.x;
    const auto widen = [&](double x) {
      a.left = std::min(a.left, x);
      a.right = std::max(a.right, x);
    };
    std::uint32_t next = a.point + 1;
    for (; next <= a.last && p[next].y < bottom; ++next) {
      a.has_level = a.has_level || p[next].y == p[next - 1].y;
      extend({p[next].x, p[next].y - top, next});
      widen(p[next].x);
    }
    if (next > a.last) {
      a.point = ended;
    } else {
      a.x = x_at(p[next - 1], p[next], bottom);
      extend({a.x, 1, next - 1});
      widen(a.x);
      a.point = next - 1;
      while (a.point < a.last && p[a.point + 1].y <= bottom) ++a.point;
      if (a.point == a.last) {
        a.point = ended;
      } else if (p[a.point].y == bottom) {
        a.x = p[a.point].x;
      }
    }
    a.segments = used_ - a.path - 1;
  }

  void row(int y) {
    used_ = 0;
    for (Place& place : order_) {
      trace(active_[place.active], y);
      place.left = active_[place.active].left;
    }
    sort();

    sink_.begin_row(y);
    std::size_t k = 0;
    while (k < order_.size() && order_[k].left < right_) {
      double right = at(k).right;
      std::size_t end = k + 1;
      for (; end < order_.size() && order_[end].left <= right; ++end) right = std::max(right, at(end).right);
      if (right <= 0) {
        for (std::size_t i = k; i < end; ++i) turn(at(i));
      } else if (end == k + 1) {
        alone(at(k));
      } else {
        together(k, end, right);
      }
      k = end;
    }
    sink_.end_row(cover_.front());
    for (; k < order_.size(); ++k) turn(at(k));
    std::erase_if(order_, [&](const Place& place) {
      if (active_[place.active].point != ended) return false;
      free_.push_back(place.active);
      return true;
    });
  }

  const Active& at(std::size_t k) const { return active_[order_[k].active]; }

  // From row to row the order hardly changes, unless many chains begin. Equal ends are told apart, so that it does not
  // depend on the rows above.
  void sort() {
    const auto is_before = [](const Place& a, const Place& b) {
      return a.left < b.left || (a.left == b.left && a.last < b.last);
    };
    std::size_t moves = 0;
    for (std::size_t k = 1; k < order_.size(); ++k) {
      if (!is_before(order_[k], order_[k - 1])) continue;
      if (moves > 8 * order_.size()) {
        std::sort(order_.begin(), order_.end(), is_before);
        return;
      }
      const Place moved = order_[k];
      std::size_t place = k;
      for (; place > 0 && is_before(moved, order_[place - 1]); --place, ++moves) order_[place] = order_[place - 1];
      order_[place] = moved;
    }
  }

  // The winding number behind a strand changes if it reaches the row's bottom; others end in level stretches that lead
  // back to where they began.
  void turn(const Active& a) {
    if (reaches_bottom(a)) wind(a.layer, a.direction);
  }
  bool reaches_bottom(const Active& a) const { return path_[a.path + a.segments].y == 1; }
  void wind(std::uint32_t layer, int by) {
    const bool was = layers_[layer].is_inside(winding_[layer]);
    winding_[layer] += by;
    const bool is = layers_[layer].is_inside(winding_[layer]);
    if (is == was) return;
    if (is) {
      cover_.insert(layer);
    } else {
      cover_.erase(layer);
    }
  }

  void alone(const Active& a) {
    const std::uint32_t before = cover_.front();
    turn(a);
    const std::uint32_t after = cover_.front();
    if (before == after) return;
    sink_.open(a.left, before);
    for (std::uint32_t k = a.path; k < a.path + a.segments; ++k) {
      const PathPoint &p = path_[k], &q = path_[k + 1];
      if (q.y > p.y) sink_.boundary(p.x, p.y, q.x, q.y, before, after, p.source);
    }
    sink_.close(a.right);
  }

  void together(std::size_t begin, std::size_t end, double right) {
    const std::uint32_t before = cover_.front();
    strands_.clear();
    for (std::size_t k = begin; k < end; ++k) {
      const Active& a = at(k);
      strands_.push_back({&path_[a.path], a.segments, a.layer, a.direction, a.left, a.right, a.has_level});
    }
    // What covers all of the cluster is found without the layers that have strands in it.
    for (const Strand& s : strands_) {
      if (layers_[s.layer].is_inside(winding_[s.layer])) cover_.erase(s.layer);
    }
    const std::uint32_t floor = cover_.front();
    const bool visible =
        std::any_of(strands_.begin(), strands_.end(), [&](const Strand& s) { return s.layer < floor; });
    if (visible) {
      sink_.open(order_[begin].left, before);
      cluster_.begin(strands_, floor, [&](std::uint32_t layer) { return winding_[layer]; });
      cluster_.resolve(sink_);
      sink_.close(right);
    }
    for (std::size_t k = begin; k < end; ++k) {
      if (reaches_bottom(at(k))) winding_[at(k).layer] += at(k).direction;
    }
    for (const Strand& s : strands_) {
      if (layers_[s.layer].is_inside(winding_[s.layer])) cover_.insert(s.layer);
    }
  }

  const Layers& layers_;
  const Chains& chains_;
  const double right_;
  Sink& sink_;
  std::vector<int> winding_;
  Cover cover_;
  Cluster cluster_;
  std::vector<Active> active_;
  std::vector<std::uint32_t> free_;  // places in active_
  std::vector<Place> order_;
  std::vector<PathPoint> path_;  // of all strands of the row
  std::uint32_t used_ = 0;
  std::vector<Strand> strands_;
};

}  // namespace area
