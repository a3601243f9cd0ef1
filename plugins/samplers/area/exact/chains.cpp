#include "exact/chains.h"

#include <algorithm>

namespace area {

namespace {

moire::Rectangle extent_of(const moire::Point* points, const Layers::Contour& contour) {
  const moire::Point p = points[contour.first];
  moire::Rectangle extent{p.x, p.y, p.x, p.y};
  for (std::uint32_t k = contour.first + 1; k < contour.end; ++k) {
    extent.x0 = std::min(extent.x0, points[k].x);
    extent.x1 = std::max(extent.x1, points[k].x);
    extent.y0 = std::min(extent.y0, points[k].y);
    extent.y1 = std::max(extent.y1, points[k].y);
  }
  return extent;
}

}  // namespace

Chains::Chains(const Layers& layers, int rows, double right) : rows_(rows) {
  points_.reserve(layers.point_count() + 2 * layers.contours().size());
  for (const Layers::Contour& contour : layers.contours()) {
    const moire::Rectangle extent = extent_of(layers.points(), contour);
    // On the left, all of a contour winds around nothing.
    if (extent.y1 <= 0 || extent.y0 >= rows || extent.x1 <= 0 || extent.x0 >= right || extent.y0 == extent.y1) continue;
    cut(layers.points(), contour);
  }
  buckets_ = RowBuckets(
      chains_.size(), rows, [&](std::uint32_t k) { return points_[chains_[k].first].y; },
      [&](std::uint32_t k) { return points_[chains_[k].last].y; });
}

void Chains::cut(const moire::Point* points, const Layers::Contour& contour) {
  const std::uint32_t count = contour.end - contour.first;
  const moire::Point* p = points + contour.first;
  const auto next = [&](std::uint32_t k) { return k + 1 == count ? 0 : k + 1; };

  // Begin where the contour turns: at a point after which it goes down and before which it did not.
  std::uint32_t start = 0;
  std::uint32_t before = count - 1;
  while (p[next(before)].y == p[before].y) --before;
  bool fell = p[next(before)].y > p[before].y;  // whether the last edge that was not level went down
  for (std::uint32_t k = 0; k < count; ++k) {
    const double y = p[k].y, after = p[next(k)].y;
    if (after == y) continue;
    if (after > y && !fell) {
      start = k;
      break;
    }
    fell = after > y;
  }

  // Once around: a chain goes on while edges keep their direction or are level.
  int direction = 0;
  auto first = static_cast<std::uint32_t>(points_.size());
  std::uint32_t k = start;
  points_.push_back(p[k]);
  for (std::uint32_t step = 0; step < count; ++step) {
    const std::uint32_t after = next(k);
    const int turn = p[after].y > p[k].y ? 1 : p[after].y < p[k].y ? -1 : 0;
    if (turn != 0 && direction != 0 && turn != direction) {
      add(first, contour.layer, direction);
      first = static_cast<std::uint32_t>(points_.size());
      points_.push_back(p[k]);
    }
    if (turn != 0) direction = turn;
    points_.push_back(p[after]);
    k = after;
  }
  add(first, contour.layer, direction);
}

void Chains::add(std::uint32_t first, std::uint32_t layer, int direction) {
  if (direction < 0) std::reverse(points_.begin() + first, points_.end());
  const auto last = static_cast<std::uint32_t>(points_.size() - 1);
  if (points_[last].y <= 0 || points_[first].y >= rows_) {
    points_.resize(first);
    return;
  }
  chains_.push_back({first, last, layer, direction});
}

}  // namespace area
