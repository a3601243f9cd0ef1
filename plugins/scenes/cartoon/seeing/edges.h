// The edges of a drawing in the image, found by the image column that they reach into.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include <moire/frame.h>

namespace cartoon {

class Outlines;

// From its left end to its right one, whichever way the contour goes: edges that two layers share are equal but for the
// layer and the turn.
struct Edge {
  double x0, x1;     // x0 < x1
  double y0, slope;  // at x0; dy / dx
  std::uint32_t layer;
  std::int16_t turn;    // 1: the contour goes to the right, -1: to the left
  std::int16_t inside;  // the winding numbers that are inside have one of these bits

  // A line upward or downward at x meets the edge. The left end belongs to it, the right one does not.
  bool meets(double x) const { return x0 <= x && x < x1; }
  // Where. The same bits for every edge between the same two points.
  double y_at(double x) const { return y0 + (x - x0) * slope; }
};

// Which winding numbers the rule counts as inside, as bits.
constexpr std::int16_t inside_bits(moire::FillRule rule) { return rule == moire::FillRule::nonzero ? -1 : 1; }

// A segment tree over the image's columns: an edge is kept in the few nodes that make up its columns, so that long
// edges take no more than 2 log2(columns) places. Columns beyond the image count as its first and last.
class Edges {
 public:
  // Of outlines with these points in the image.
  Edges(const Outlines& outlines, std::span<const moire::Point> points, int columns);

  std::int64_t column_of(double x) const {
    return static_cast<std::int64_t>(std::clamp(x, 0.0, static_cast<double>(columns_ - 1)));
  }

  // Calls visit(edge) for every edge that reaches into the column: those of one node are ordered by layer.
  template <class Visit>
  void in_column(std::int64_t column, Visit visit) const {
    for (std::size_t node = static_cast<std::size_t>(column + leaves_); node > 0; node /= 2) {
      for (std::size_t k = first_[node]; k < first_[node + 1]; ++k) visit(edges_[kept_[k]]);
    }
  }

 private:
  template <class Visit>
  void for_each_node(const Edge& edge, Visit visit) const;

  std::int64_t columns_, leaves_;   // leaves: a power of two
  std::vector<Edge> edges_;         // layer by layer
  std::vector<std::size_t> first_;  // of each node's edges in kept_; node 1 is the root, 2 n and 2 n + 1 are below n
  std::vector<std::uint32_t> kept_;
};

}  // namespace cartoon
