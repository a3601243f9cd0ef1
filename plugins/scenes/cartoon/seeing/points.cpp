#include "points.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "stack.h"

namespace cartoon {

namespace {

using moire::SamplePoint;

// Where an upright line meets an edge, in the list of those that the next point above comes after.
struct Meeting {
  std::uint32_t layer;
  std::int16_t turn, inside;
  std::uint32_t next;
};
constexpr std::uint32_t none = 0xffffffffU;

// By value, so that what is written cannot change what is read and stays in registers.
void fill(std::span<moire::Hit> hits, moire::Hit hit) {
  const auto [element, color] = hit;
  const auto [r, g, b] = color;
  for (moire::Hit& h : hits) h = {element, {r, g, b}};
}

// Points on one upright line, each above the one before: every edge that the line meets belongs to the first point
// above it, and a stack of layers goes up from point to point.
class Climb {
 public:
  // Returns how many hits are none of the background.
  std::size_t find(const Edges& edges, std::span<const moire::Hit> with, std::span<const SamplePoint> points,
                   std::span<moire::Hit> hits) {
    stack_.reserve(with.size());
    meet(edges, points);
    moire::Hit hit = with.back();
    std::size_t known = 0, not_background = 0;
    const auto see_up_to = [&](std::size_t k) {
      fill(hits.subspan(known, k - known), hit);
      if (hit.element != moire::background) not_background += k - known;
      known = k;
    };
    for (std::size_t word = 0; word < met_.size(); ++word) {
      for (std::uint64_t bits = met_[word]; bits != 0; bits &= bits - 1) {
        const std::size_t k = word * 64 + static_cast<std::size_t>(std::countr_zero(bits));
        see_up_to(k);
        for (std::uint32_t m = first_[k]; m != none; m = meetings_[m].next) {
          stack_.turn(meetings_[m].layer, meetings_[m].turn, meetings_[m].inside);
        }
        const std::uint32_t top = stack_.top();
        hit = top == Stack::empty ? with.back() : with[top];
      }
    }
    see_up_to(points.size());
    for (const Meeting& meeting : meetings_) stack_.clear(meeting.layer);
    return not_background;
  }

 private:
  void meet(const Edges& edges, std::span<const SamplePoint> points) {
    meetings_.clear();
    first_.resize(points.size());
    met_.assign((points.size() + 63) / 64, 0);
    const double x = points.front().x, lowest = points.front().y, highest = points.back().y;
    const auto last = static_cast<double>(points.size() - 1);
    const double rate = lowest > highest ? last / (lowest - highest) : 0;
    edges.in_column(edges.column_of(x), [&](const Edge& edge) {
      if (!edge.meets(x)) return;
      const double y = edge.y_at(x);
      if (!(y > highest)) return;
      // Points mostly have even distances: a guess, then the next ones.
      auto k = static_cast<std::size_t>(std::clamp((lowest - y) * rate, 0.0, last));
      while (!(points[k].y < y)) ++k;
      while (k > 0 && points[k - 1].y < y) --k;
      const std::uint64_t bit = std::uint64_t{1} << k % 64;
      const bool is_first = (met_[k / 64] & bit) == 0;
      met_[k / 64] |= bit;
      meetings_.push_back({edge.layer, edge.turn, edge.inside, is_first ? none : first_[k]});
      first_[k] = static_cast<std::uint32_t>(meetings_.size() - 1);
    });
  }

  Stack stack_;
  std::vector<Meeting> meetings_;
  std::vector<std::uint64_t> met_;    // a bit for each point that comes after an edge
  std::vector<std::uint32_t> first_;  // of those points, in meetings_
};

// Points of one image column in any order: the column's edges, layer by layer from the top one.
class Strip {
 public:
  std::size_t find(const Edges& edges, std::span<const moire::Hit> with, std::span<const SamplePoint> points,
                   std::span<moire::Hit> hits) {
    std::size_t not_background = 0;
    gather(edges, points);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const std::uint32_t layer = layer_at(points[k].x, points[k].y);
      hits[k] = layer == Stack::empty ? with.back() : with[layer];
      not_background += layer == Stack::empty ? 0 : 1;
    }
    return not_background;
  }

 private:
  struct Part {
    std::uint32_t layer;
    std::int32_t inside;
    std::size_t first, end;  // in edges_
    double low, high;        // at no x of the points is one of its edges beyond
  };

  void gather(const Edges& edges, std::span<const SamplePoint> points) {
    const auto ends = std::ranges::minmax(points, {}, &SamplePoint::x);
    const double left = ends.min.x, right = ends.max.x;
    edges_.clear();
    edges.in_column(edges.column_of(left), [&](const Edge& edge) {
      if (edge.x0 <= right && edge.x1 > left) edges_.push_back(&edge);
    });
    std::ranges::sort(edges_,
                      [](const Edge* p, const Edge* q) { return p->layer != q->layer ? p->layer > q->layer : p < q; });

    parts_.clear();
    for (std::size_t k = 0; k < edges_.size(); ++k) {
      const Edge& edge = *edges_[k];
      if (parts_.empty() || parts_.back().layer != edge.layer) {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        parts_.push_back({edge.layer, edge.inside, k, k, infinity, -infinity});
      }
      // y_at rises or falls with x, rounding included.
      const double y0 = edge.y_at(std::max(left, edge.x0)), y1 = edge.y_at(std::min(right, edge.x1));
      Part& part = parts_.back();
      part.low = std::min({part.low, y0, y1});
      part.high = std::max({part.high, y0, y1});
      part.end = k + 1;
    }
  }

  std::uint32_t layer_at(double x, double y) const {
    for (const Part& part : parts_) {
      // Below all edges none is met; above all of them their turns cancel out.
      if (y < part.low || y >= part.high) continue;
      std::int32_t winding = 0;
      for (std::size_t k = part.first; k < part.end; ++k) {
        const Edge& edge = *edges_[k];
        if (edge.meets(x) && edge.y_at(x) > y) winding += edge.turn;
      }
      if ((winding & part.inside) != 0) return part.layer;
    }
    return Stack::empty;
  }

  std::vector<const Edge*> edges_;
  std::vector<Part> parts_;
};

// Whether each point is above the one before, at the same x. Without branches: mostly they all are.
bool climbs(std::span<const SamplePoint> points) {
  int breaks = 0;
  for (std::size_t k = 1; k < points.size(); ++k) {
    breaks |= static_cast<int>(points[k].x != points[k - 1].x) | static_cast<int>(points[k].y > points[k - 1].y);
  }
  return breaks == 0;
}

}  // namespace

std::size_t find_hits(const Edges& edges, std::span<const moire::Hit> with, std::span<const SamplePoint> points,
                      std::span<moire::Hit> hits) {
  // Their memory serves many batches. Between calls the stack is clear.
  thread_local Climb climb;
  thread_local Strip strip;
  if (points.empty()) return 0;
  if (climbs(points)) return climb.find(edges, with, points, hits);
  std::size_t not_background = 0;
  for (std::size_t first = 0; first < points.size();) {
    const std::int64_t column = edges.column_of(points[first].x);
    std::size_t end = first + 1;
    while (end < points.size() && edges.column_of(points[end].x) == column) ++end;
    const auto some = points.subspan(first, end - first);
    const auto theirs = hits.subspan(first, end - first);
    not_background += climbs(some) ? climb.find(edges, with, some, theirs) : strip.find(edges, with, some, theirs);
    first = end;
  }
  return not_background;
}

}  // namespace cartoon
