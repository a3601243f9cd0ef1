#include "metrics/point_set.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>

namespace moire {

double star_discrepancy(std::span<const Point> points) {
  const auto count = static_cast<double>(points.size());
  double single = 0, paired = 0;
  for (const Point& p : points) {
    single += (1 - p.x * p.x) * (1 - p.y * p.y);
    for (const Point& q : points) paired += (1 - std::max(p.x, q.x)) * (1 - std::max(p.y, q.y));
  }
  return std::sqrt(std::max(0.0, 1.0 / 9 - single / (2 * count) + paired / (count * count)));
}

std::vector<Point> point_power(std::span<const Point> points, int reach) {
  std::vector<double> sums(static_cast<std::size_t>(reach) + 1), counts(sums.size());
  // Half of the plane: the other half is its mirror.
  for (int u = 0; u <= reach; ++u) {
    for (int v = u == 0 ? 1 : -reach; v <= reach; ++v) {
      const auto ring = static_cast<std::size_t>(std::lround(std::hypot(u, v)));
      if (ring >= sums.size()) continue;
      std::complex<double> sum = 0;
      for (const Point& p : points) sum += std::polar(1.0, -2 * std::numbers::pi * (u * p.x + v * p.y));
      sums[ring] += std::norm(sum) / static_cast<double>(points.size());
      ++counts[ring];
    }
  }
  std::vector<Point> result;
  for (std::size_t ring = 1; ring < sums.size(); ++ring)
    result.push_back({static_cast<double>(ring), sums[ring] / counts[ring]});
  return result;
}

}  // namespace moire
