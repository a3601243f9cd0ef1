// The visible boundaries among strands that overlap in x within one row.
//
// Strands are pieces of chains. They are sorted by x into groups that do not touch. In a group everything behind the
// foremost layer that covers all of it is left out, and what remains falls into groups again. A group of strands that
// go straight from the top of its stretch of y to the bottom without crossing is read from left to right; any other is
// divided in y, where a strand bends, ends or crosses its neighbour, as near the middle as there is one, and each part
// begins anew.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "exact/layers.h"
#include "exact/path.h"

namespace area {

// A strand of a row before anything is divided.
struct Strand {
  const PathPoint* path;  // from the upper end to the lower
  std::uint32_t segments;
  std::uint32_t layer;
  int direction;
  double left, right;
};

class Cluster {
 public:
  explicit Cluster(const Layers& layers) : layers_(layers) {}

  // Begins a cluster: its strands by rising `left`, the winding numbers of their layers on their left, by
  // winding(layer), and what is foremost of the layers that have no strand here.
  template <class Winding>
  void begin(std::span<const Strand> strands, std::uint32_t floor, Winding winding) {
    strands_ = strands;
    floor_ = floor;
    local_.clear();
    for (const Strand& strand : strands) local_.push_back(strand.layer);
    std::sort(local_.begin(), local_.end());
    local_.erase(std::unique(local_.begin(), local_.end()), local_.end());
    winding_.clear();
    inside_.assign((local_.size() + 63) / 64, 0);
    for (std::uint32_t k = 0; k < local_.size(); ++k) {
      winding_.push_back(winding(local_[k]));
      mark(k);
    }
    items_.clear();
    for (std::uint32_t k = 0; k < strands.size(); ++k) {
      const Strand& s = strands[k];
      const PathPoint &a = s.path[0], &b = s.path[s.segments];
      const auto place = std::lower_bound(local_.begin(), local_.end(), s.layer) - local_.begin();
      items_.push_back({k, static_cast<std::uint32_t>(place), 0, s.segments - 1, a.x, a.y, b.x, b.y, s.left, s.right});
    }
  }

  // Calls sink.boundary(x0, y0, x1, y1, left layer, right layer, source) for all that is visible.
  template <class Sink>
  void resolve(Sink& sink) {
    groups(0, items_.size(), 0, 1, sink);
  }

 private:
  // A strand between ya and yb: from (xa, ya) on segment `first` to (xb, yb) on segment `last`.
  struct Item {
    std::uint32_t strand, layer;  // layer: an index of local_
    std::uint32_t first, last;
    double xa, ya, xb, yb, left, right;
  };

  // Equal but for rounding: closer than two edges can be told apart at x.
  static double slack(double x) { return 0x1p-51 * std::max(1.0, std::abs(x)); }

  int direction(const Item& item) const { return strands_[item.strand].direction; }
  const PathPoint* path(const Item& item) const { return strands_[item.strand].path; }

  void mark(std::uint32_t layer) {
    const std::uint64_t bit = std::uint64_t{1} << (layer % 64);
    if (layers_[local_[layer]].is_inside(winding_[layer])) {
      inside_[layer / 64] |= bit;
    } else {
      inside_[layer / 64] &= ~bit;
    }
  }
  void turn(const Item& item) {
    winding_[item.layer] += direction(item);
    mark(item.layer);
  }
  // The foremost layer of `inside`, as it is numbered in layers_.
  std::uint32_t front(const std::vector<std::uint64_t>& inside) const {
    for (std::size_t k = 0; k < inside.size(); ++k) {
      if (inside[k] != 0)
        return std::min(floor_, local_[64 * k + static_cast<std::size_t>(std::countr_zero(inside[k]))]);
    }
    return floor_;
  }

  // Items [begin, end) of items_, between ya and yb. Afterwards the winding numbers are those on their right.
  template <class Sink>
  void groups(std::size_t begin, std::size_t end, double ya, double yb, Sink& sink) {
    std::sort(items_.begin() + static_cast<std::ptrdiff_t>(begin), items_.begin() + static_cast<std::ptrdiff_t>(end),
              [](const Item& a, const Item& b) { return a.left < b.left; });
    for (std::size_t first = begin; first < end;) {
      double right = items_[first].right;
      std::size_t next = first + 1;
      for (; next < end && items_[next].left <= right; ++next) right = std::max(right, items_[next].right);
      if (next == first + 1) {
        pass(items_[first], sink);
      } else {
        group(first, next, ya, yb, sink);
      }
      first = next;
    }
  }

  template <class Sink>
  void pass(const Item& item, Sink& sink) {
    const std::uint32_t before = front(inside_);
    turn(item);
    const std::uint32_t after = front(inside_);
    if (before == after) return;
    const PathPoint* p = path(item);
    double x = item.xa, y = item.ya;
    for (std::uint32_t k = item.first; k < item.last; ++k) {
      if (p[k + 1].y > y) sink.boundary(x, y, p[k + 1].x, p[k + 1].y, before, after, p[k].source);
      x = p[k + 1].x;
      y = p[k + 1].y;
    }
    if (item.yb > y) sink.boundary(x, y, item.xb, item.yb, before, after, p[item.last].source);
  }

  template <class Sink>
  void group(std::size_t begin, std::size_t end, double ya, double yb, Sink& sink) {
    // What covers all of the group hides all that is behind it.
    std::vector<std::uint64_t>& rest = rest_;
    rest = inside_;
    for (std::size_t k = begin; k < end; ++k)
      rest[items_[k].layer / 64] &= ~(std::uint64_t{1} << (items_[k].layer % 64));
    const std::uint32_t cover = front(rest);
    const auto is_hidden = [&](const Item& item) { return local_[item.layer] > cover; };
    const auto hidden =
        static_cast<std::size_t>(std::count_if(items_.begin() + static_cast<std::ptrdiff_t>(begin),
                                               items_.begin() + static_cast<std::ptrdiff_t>(end), is_hidden));
    if (hidden > 0) {
      const std::size_t visible = items_.size();
      for (std::size_t k = begin; k < end; ++k) {
        if (!is_hidden(items_[k])) items_.push_back(Item(items_[k]));
      }
      groups(visible, items_.size(), ya, yb, sink);
      items_.resize(visible);
      for (std::size_t k = begin; k < end; ++k) {
        if (is_hidden(items_[k]) && items_[k].yb == yb) turn(items_[k]);
      }
      return;
    }
    double cut = 0;
    if (find_bend(begin, end, ya, yb, cut) || !is_ordered(begin, end, ya, yb, cut)) {
      divide(begin, end, ya, cut, yb, sink);
      return;
    }
    for (std::size_t k = begin; k < end; ++k) pass(items_[k], sink);
  }

  // The place nearest the middle where an item bends or ends between ya and yb, if there is one.
  bool find_bend(std::size_t begin, std::size_t end, double ya, double yb, double& cut) const {
    const double middle = (ya + yb) / 2;
    bool found = false;
    const auto consider = [&](double y) {
      if (y <= ya || y >= yb || (found && std::abs(y - middle) >= std::abs(cut - middle))) return;
      found = true;
      cut = y;
    };
    for (std::size_t k = begin; k < end; ++k) {
      const Item& item = items_[k];
      consider(item.ya);
      consider(item.yb);
      for (std::uint32_t v = item.first + 1; v <= item.last; ++v) consider(path(item)[v].y);
    }
    return found;
  }

  // Sorts items that are straight from ya to yb by x in the middle, since vertices that edges share tie at the ends.
  // False: some neighbours cross, at `cut`.
  bool is_ordered(std::size_t begin, std::size_t end, double ya, double yb, double& cut) {
    std::sort(items_.begin() + static_cast<std::ptrdiff_t>(begin), items_.begin() + static_cast<std::ptrdiff_t>(end),
              [](const Item& a, const Item& b) {
                const double ma = a.xa + a.xb, mb = b.xa + b.xb;
                return ma < mb || (ma == mb && a.strand < b.strand);
              });
    const double middle = (ya + yb) / 2;
    bool ordered = true;
    for (std::size_t k = begin + 1; k < end; ++k) {
      const Item &p = items_[k - 1], &q = items_[k];
      const double above = q.xa - p.xa, below = q.xb - p.xb;
      if (above >= -slack(p.xa) && below >= -slack(p.xb)) continue;
      const double y = ya + above / (above - below) * (yb - ya);
      if (!(y > ya && y < yb) || (!ordered && std::abs(y - middle) >= std::abs(cut - middle))) continue;
      ordered = false;
      cut = y;
    }
    return ordered;
  }

  template <class Sink>
  void divide(std::size_t begin, std::size_t end, double ya, double cut, double yb, Sink& sink) {
    const std::size_t base = items_.size();
    const std::size_t state = saved_.size();
    saved_.insert(saved_.end(), winding_.begin(), winding_.end());

    for (std::size_t k = begin; k < end; ++k) {
      if (items_[k].ya < cut) items_.push_back(upper(items_[k], cut));
    }
    groups(base, items_.size(), ya, cut, sink);
    items_.resize(base);

    std::copy(saved_.begin() + static_cast<std::ptrdiff_t>(state), saved_.end(), winding_.begin());
    saved_.resize(state);
    for (std::uint32_t k = 0; k < local_.size(); ++k) mark(k);
    for (std::size_t k = begin; k < end; ++k) {
      if (items_[k].yb > cut) items_.push_back(lower(items_[k], cut));
    }
    groups(base, items_.size(), cut, yb, sink);
    items_.resize(base);
  }

  // x of `item` at y, on segment `segment`.
  double x_on(const Item& item, std::uint32_t segment, double y) const {
    const PathPoint* p = path(item) + segment;
    return p[0].y == y ? p[0].x : x_at(p[0], p[1], y);
  }

  // Without the level stretches at the cut: they join nothing above or below it.
  Item upper(const Item& item, double cut) const {
    if (item.yb < cut) return item;
    Item part = item;
    while (part.last > part.first && path(item)[part.last].y >= cut) --part.last;
    part.xb = x_on(item, part.last, cut);
    part.yb = cut;
    return measured(part);
  }
  Item lower(const Item& item, double cut) const {
    if (item.ya > cut) return item;
    Item part = item;
    while (part.first < part.last && path(item)[part.first + 1].y <= cut) ++part.first;
    part.xa = x_on(item, part.first, cut);
    part.ya = cut;
    return measured(part);
  }
  Item measured(Item item) const {
    item.left = std::min(item.xa, item.xb);
    item.right = std::max(item.xa, item.xb);
    for (std::uint32_t v = item.first + 1; v <= item.last; ++v) {
      item.left = std::min(item.left, path(item)[v].x);
      item.right = std::max(item.right, path(item)[v].x);
    }
    return item;
  }

  const Layers& layers_;
  std::span<const Strand> strands_;
  std::uint32_t floor_ = 0;
  std::vector<std::uint32_t> local_;  // the layers that have strands here, front to back
  std::vector<int> winding_;          // of each
  std::vector<std::uint64_t> inside_, rest_;
  std::vector<Item> items_;  // those of an inner call follow those of the outer one
  std::vector<int> saved_;
};

}  // namespace area
