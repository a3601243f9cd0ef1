#include "edges.h"

#include <bit>
#include <limits>
#include <numeric>

#include "drawing/outlines.h"

namespace cartoon {

namespace {

using moire::Point;

// Requires: the ends differ in x.
Edge edge_between(Point from, Point to, std::uint32_t layer, moire::FillRule rule) {
  const bool goes_right = from.x < to.x;
  const Point left = goes_right ? from : to, right = goes_right ? to : from;
  constexpr double steepest = std::numeric_limits<double>::max();  // y_at(x0) is y0 even so
  const double slope = std::clamp((right.y - left.y) / (right.x - left.x), -steepest, steepest);
  return {left.x, right.x, left.y, slope, layer, static_cast<std::int16_t>(goes_right ? 1 : -1), inside_bits(rule)};
}

}  // namespace

template <class Visit>
void Edges::for_each_node(const Edge& edge, Visit visit) const {
  auto low = static_cast<std::size_t>(column_of(edge.x0) + leaves_);
  auto high = static_cast<std::size_t>(column_of(edge.x1) + leaves_ + 1);
  for (; low < high; low /= 2, high /= 2) {
    if (low % 2 == 1) visit(low++);
    if (high % 2 == 1) visit(--high);
  }
}

Edges::Edges(const Outlines& outlines, std::span<const Point> points, int columns)
    : columns_(columns), leaves_(static_cast<std::int64_t>(std::bit_ceil(static_cast<unsigned>(columns)))) {
  edges_.reserve(points.size());
  for (std::size_t k = 0; k < outlines.layers(); ++k) {
    const moire::Polygon polygon = outlines.polygon(k, points);
    for (std::size_t c = 0; c < polygon.contours.size(); ++c) {
      const std::size_t first = polygon.contours[c];
      const std::size_t end = c + 1 < polygon.contours.size() ? polygon.contours[c + 1] : polygon.points.size();
      Point from = polygon.points[end - 1];
      for (std::size_t p = first; p < end; ++p) {
        const Point to = polygon.points[p];
        if (from.x != to.x) {
          edges_.push_back(edge_between(from, to, static_cast<std::uint32_t>(k), polygon.rule));
        }
        from = to;
      }
    }
  }

  first_.assign(static_cast<std::size_t>(2 * leaves_) + 1, 0);
  for (const Edge& edge : edges_) for_each_node(edge, [&](std::size_t node) { ++first_[node + 1]; });
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  kept_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t k = 0; k < edges_.size(); ++k) {
    for_each_node(edges_[k], [&](std::size_t node) { kept_[next[node]++] = static_cast<std::uint32_t>(k); });
  }
}

}  // namespace cartoon
