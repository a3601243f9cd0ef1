// The visible boundaries among strands that overlap in x within one row.
//
// Strands are pieces of chains. They are sorted by x into groups that do not touch. In a group everything behind the
// foremost layer that covers all of it is left out, and what remains falls into groups again. A group of strands that
// run side by side from one y to another without crossing is read from left to right; any other is divided in y, where
// a strand ends or crosses its neighbour, as near the middle as there is such a place, and each part begins anew.
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
  bool has_level;  // some stretch of it is level
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
      items_.push_back(
          {k, static_cast<std::uint32_t>(place), 0, s.segments - 1, a.x, a.y, b.x, b.y, s.left, s.right, 0});
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
    double key;  // by which is_ordered() sorts
  };

  // Equal but for rounding: closer than two edges can be told apart at x.
  static double slack(double x) { return 0x1p-51 * std::max(1.0, std::abs(x)); }

  // Most groups are so small that nothing is faster than insertion.
  template <class Less>
  void sort(std::size_t begin, std::size_t end, Less less) {
    if (end - begin > 16) {
      std::sort(items_.begin() + static_cast<std::ptrdiff_t>(begin), items_.begin() + static_cast<std::ptrdiff_t>(end),
                less);
      return;
    }
    for (std::size_t k = begin + 1; k < end; ++k) {
      if (!less(items_[k], items_[k - 1])) continue;
      const Item item = items_[k];
      std::size_t place = k;
      for (; place > begin && less(item, items_[place - 1]); --place) items_[place] = items_[place - 1];
      items_[place] = item;
    }
  }

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
    sort(begin, end, [](const Item& a, const Item& b) { return a.left < b.left; });
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
    rest_ = inside_;
    for (std::size_t k = begin; k < end; ++k)
      rest_[items_[k].layer / 64] &= ~(std::uint64_t{1} << (items_[k].layer % 64));
    const std::uint32_t cover = front(rest_);
    const auto is_hidden = [&](const Item& item) { return local_[item.layer] > cover; };
    const auto hidden =
        static_cast<std::size_t>(std::count_if(items_.begin() + static_cast<std::ptrdiff_t>(begin),
                                               items_.begin() + static_cast<std::ptrdiff_t>(end), is_hidden));
    if (hidden > 0) {
      const std::size_t visible = items_.size();
      for (std::size_t k = begin; k < end; ++k) {
        if (!is_hidden(items_[k])) items_.push_back(items_[k]);
      }
      groups(visible, items_.size(), ya, yb, sink);
      items_.resize(visible);
      for (std::size_t k = begin; k < end; ++k) {
        if (is_hidden(items_[k]) && items_[k].yb == yb) turn(items_[k]);
      }
      return;
    }
    double cut = 0;
    if (find_end(begin, end, ya, yb, cut) || !is_ordered(begin, end, ya, yb, cut)) {
      divide(begin, end, ya, cut, yb, sink);
      return;
    }
    for (std::size_t k = begin; k < end; ++k) pass(items_[k], sink);
  }

  // Of places between ya and yb, the one nearest the middle.
  class Cut {
   public:
    Cut(double ya, double yb) : ya_(ya), yb_(yb) {}
    bool is_inside(double y) const { return y > ya_ && y < yb_; }
    void consider(double y) {
      if (!is_inside(y) || (found_ && std::abs(y - (ya_ + yb_) / 2) >= std::abs(y_ - (ya_ + yb_) / 2))) return;
      found_ = true;
      y_ = y;
    }
    bool found() const { return found_; }
    double y() const { return y_; }

   private:
    double ya_, yb_, y_ = 0;
    bool found_ = false;
  };

  // A place where some items end or run level. False: between ya and yb all begin and end at the same places.
  bool find_end(std::size_t begin, std::size_t end, double& ya, double& yb, double& y) const {
    const auto first = items_.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = items_.begin() + static_cast<std::ptrdiff_t>(end);
    // What two strands that begin or end together leave free belongs to neither.
    ya = first->ya;
    yb = first->yb;
    for (auto item = first + 1; item != last; ++item) {
      ya = std::min(ya, item->ya);
      yb = std::max(yb, item->yb);
    }
    Cut cut(ya, yb);
    for (auto item = first; item != last; ++item) {
      cut.consider(item->ya);
      cut.consider(item->yb);
      if (!strands_[item->strand].has_level) continue;
      for (std::uint32_t v = item->first + 1; v < item->last; ++v) {
        if (path(*item)[v].y == path(*item)[v + 1].y) cut.consider(path(*item)[v].y);
      }
    }
    y = cut.y();
    return cut.found();
  }

  // Sorts items that all run from ya to yb. Not by their ends alone, since vertices that edges share tie there. False:
  // some neighbours cross, at `y`.
  bool is_ordered(std::size_t begin, std::size_t end, double ya, double yb, double& y) {
    const double middle = (ya + yb) / 2;
    for (std::size_t k = begin; k < end; ++k) {
      Item& item = items_[k];
      if (strands_[item.strand].has_level) trim(item);
      item.key = item.xa + item.xb +
                 (item.first == item.last ? item.xa + item.xb : 2 * x_on(item, segment_at(item, middle), middle));
    }
    sort(begin, end,
         [](const Item& a, const Item& b) { return a.key < b.key || (a.key == b.key && a.strand < b.strand); });
    Cut cut(ya, yb);
    for (std::size_t k = begin + 1; k < end; ++k) compare(items_[k - 1], items_[k], cut);
    y = cut.y();
    return !cut.found();
  }

  // Leaves out level stretches at the ends, which join nothing that lies between them.
  void trim(Item& item) const {
    const PathPoint* p = path(item);
    while (p[item.first + 1].y == item.ya) item.xa = p[++item.first].x;
    while (p[item.last].y == item.yb) item.xb = p[item.last--].x;
  }

  // Considers where `right`, which ought to lie right of `left`, does not: their crossing, or, where that is one of the
  // ends, the bend next to it.
  void compare(const Item& left, const Item& right, Cut& cut) const {
    const PathPoint *p = path(left), *q = path(right);
    std::uint32_t i = left.first, j = right.first;
    double y = left.ya, gap = right.xa - left.xa;
    bool was_ordered = gap >= -slack(left.xa);
    while (true) {
      const double end_p = i < left.last ? p[i + 1].y : left.yb, end_q = j < right.last ? q[j + 1].y : right.yb;
      const double next = std::min(end_p, end_q);
      const bool is_end = i == left.last && j == right.last;
      const double xp = is_end ? left.xb : x_at(p[i], p[i + 1], next);
      const double xq = is_end ? right.xb : x_at(q[j], q[j + 1], next);
      const double next_gap = xq - xp;
      const bool is_now = next_gap >= -slack(xp);
      if (!was_ordered || !is_now) {
        const double crossing = gap == next_gap ? y : y + gap / (gap - next_gap) * (next - y);
        if (was_ordered != is_now && cut.is_inside(crossing)) {
          cut.consider(crossing);
        } else {
          cut.consider(next);
          cut.consider(y);
        }
      }
      if (is_end) return;
      if (end_p == next && i < left.last) ++i;
      if (end_q == next && j < right.last) ++j;
      y = next;
      gap = next_gap;
      was_ordered = is_now;
    }
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

  // The segment of `item` that is at y.
  std::uint32_t segment_at(const Item& item, double y) const {
    std::uint32_t segment = item.first;
    while (segment < item.last && path(item)[segment + 1].y <= y) ++segment;
    return segment;
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
    part.first = segment_at(item, cut);
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
