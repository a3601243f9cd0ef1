#include "sampling/strands.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <moire/error.h>

namespace moire {

namespace {

// The sum of the weights, which they are divided by.
double checked_sum(std::span<const Points::Entry> points, const Pixel& pixel) {
  double sum = 0;
  if (points.empty())
    throw Error(fmt::format("pixel ({}, {}): the sampler gave no points; at least one is needed", pixel.x, pixel.y));
  for (const Points::Entry& point : points) {
    const bool inside = point.x >= 0 && point.x < 1 && point.y >= 0 && point.y < 1;
    if (!inside || !std::isfinite(point.weight)) {
      throw Error(
          fmt::format("pixel ({}, {}): the sampler gave point ({}, {}) of weight {}; points lie in [0, 1) x [0, 1) "
                      "and have finite weights",
                      pixel.x, pixel.y, point.x, point.y, point.weight));
    }
    sum += point.weight;
  }
  if (sum == 0 || !std::isfinite(sum)) {
    throw Error(fmt::format(
        "pixel ({}, {}): the sampler gave points whose weights sum to {}; the sum is a finite number other than 0",
        pixel.x, pixel.y, sum));
  }
  return sum;
}

// The left ends of the strips: each distinct x where points share few, else equal strips, as many as the root of the
// number of points.
std::vector<double> strips(std::span<const Points::Entry> points) {
  const auto most = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(points.size()))));
  std::vector<double> ends;
  for (const Points::Entry& point : points) ends.push_back(point.x);
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  if (ends.size() <= most) return ends;
  ends.resize(most);
  for (std::size_t k = 0; k < most; ++k) ends[k] = static_cast<double>(k) / static_cast<double>(most);
  return ends;
}

}  // namespace

Strands::Strands(const PointSampler& sampler, Pixel pixel, int y0, int height, std::optional<Point> shift) {
  const auto [left, up] = shift.value_or(Point{});
  Points points;
  std::vector<double> ends;
  std::vector<Points::Entry> sorted;
  double sum = 0;
  for (int row = height - 1; row >= 0; --row) {
    pixel.y = y0 + row;
    if (row == height - 1 || !sampler.same_in_every_pixel()) {
      points.clear();
      sampler.points(pixel, points);
      sum = checked_sum(points.entries(), pixel);
      ends = strips(points.entries());
      sorted.assign(points.entries().begin(), points.entries().end());
      std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.y > b.y; });
    }
    if (strands_.size() < ends.size()) strands_.resize(ends.size());
    for (const Points::Entry& point : sorted) {
      const auto strip = std::upper_bound(ends.begin(), ends.end(), point.x) - ends.begin() - 1;
      Strand& strand = strands_[static_cast<std::size_t>(strip)];
      strand.points.push_back({pixel.x + (point.x - left), pixel.y + (point.y - up)});
      strand.offsets.push_back(point.x - left);
      strand.rows.push_back(static_cast<std::uint32_t>(row));
      strand.weights.push_back(point.weight / sum);
      if (shift) strand.places.push_back({point.x - point.moved.x - left, point.y - point.moved.y - up});
    }
  }
}

void Strands::move_to(int x) {
  for (Strand& strand : strands_) {
    for (std::size_t k = 0; k < strand.points.size(); ++k) strand.points[k].x = x + strand.offsets[k];
  }
}

}  // namespace moire
