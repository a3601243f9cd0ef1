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
    if (point.light && !(point.light->u >= 0 && point.light->u < 1 && point.light->v >= 0 && point.light->v < 1)) {
      throw Error(
          fmt::format("pixel ({}, {}): the sampler gave point ({}, {}) of the light; such points lie in "
                      "[0, 1) x [0, 1)",
                      pixel.x, pixel.y, point.light->u, point.light->v));
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

// The upright strips of a pixel that its points are sorted into: one for each distinct x where points share few, else
// equal ones, as many as the root of the number of points.
class Strips {
 public:
  void divide(std::span<const Points::Entry> points) {
    count_ = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(points.size()))));
    shared_.clear();
    for (const Points::Entry& point : points) {
      const auto place = std::lower_bound(shared_.begin(), shared_.end(), point.x);
      if (place != shared_.end() && *place == point.x) continue;
      if (shared_.size() == count_) return shared_.clear();  // too many: equal strips
      shared_.insert(place, point.x);
    }
    count_ = shared_.size();
  }

  std::size_t count() const { return count_; }
  // Requires: x is that of one of the points.
  std::size_t of(double x) const {
    if (shared_.empty()) return std::min(static_cast<std::size_t>(x * static_cast<double>(count_)), count_ - 1);
    return static_cast<std::size_t>(std::lower_bound(shared_.begin(), shared_.end(), x) - shared_.begin());
  }

 private:
  std::size_t count_ = 0;
  std::vector<double> shared_;  // rising
};

// From the pixel's lower edge to its upper one; points of one height in the order in which they were given.
void order_upward(std::span<const Points::Entry> points, std::vector<std::pair<double, std::uint32_t>>& order) {
  order.clear();
  for (const Points::Entry& point : points) order.emplace_back(-point.y, static_cast<std::uint32_t>(order.size()));
  std::sort(order.begin(), order.end());
}

}  // namespace

Strands::Strands(const PointSampler& sampler, Pixel pixel, int y0, int height, LightSeed light_seed,
                 std::optional<Point> shift) {
  const auto [left, up] = shift.value_or(Point{});
  Points points;
  Strips strips;
  std::vector<std::pair<double, std::uint32_t>> order;
  double sum = 0;
  for (int row = height - 1; row >= 0; --row) {
    pixel.y = y0 + row;
    if (row == height - 1 || !sampler.same_in_every_pixel()) {
      points.clear();
      sampler.points(pixel, points);
      sum = checked_sum(points.entries(), pixel);
      strips.divide(points.entries());
      order_upward(points.entries(), order);
    }
    std::optional<LightLattice> lights;
    if (light_seed) lights.emplace(pixel, *light_seed, static_cast<std::uint32_t>(order.size()));
    if (strands_.size() < strips.count()) grow(strips.count(), order.size() * static_cast<std::size_t>(height));
    for (const auto& place : order) {
      const Points::Entry& point = points.entries()[place.second];
      Strand& strand = strands_[strips.of(point.x)];
      strand.points.push_back({pixel.x + (point.x - left), pixel.y + (point.y - up)});
      if (lights) {
        const LightPoint light = point.light.value_or(lights->point(place.second));
        strand.points.back().u = light.u, strand.points.back().v = light.v;
      }
      strand.offsets.push_back(point.x - left);
      strand.rows.push_back(static_cast<std::uint32_t>(row));
      strand.weights.push_back(point.weight / sum);
      if (shift) strand.places.push_back({point.x - point.moved.x - left, point.y - point.moved.y - up});
    }
  }
}

void Strands::grow(std::size_t count, std::size_t points) {
  strands_.resize(count);
  const std::size_t each = points / count + points / (8 * count);
  for (Strand& strand : strands_) {
    strand.points.reserve(each);
    strand.rows.reserve(each);
    strand.offsets.reserve(each);
    strand.weights.reserve(each);
  }
}

void Strands::move_to(int x) {
  for (Strand& strand : strands_) {
    for (std::size_t k = 0; k < strand.points.size(); ++k) strand.points[k].x = x + strand.offsets[k];
  }
}

}  // namespace moire
