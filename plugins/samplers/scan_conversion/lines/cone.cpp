#include "cone.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace scan_conversion {

namespace {

// The integral of 1 - sqrt(x^2 + y^2) over x, from 0.
double slice(double x, double y) {
  const double bent = y == 0 ? 0 : y * y * std::asinh(x / std::abs(y));
  return x - (x * std::hypot(x, y) + bent) / 2;
}

}  // namespace

double cone_share(double along, double across) {
  const double low = std::max(across - 0.5, -1.0), high = std::min(across + 0.5, 1.0);
  if (low >= high || along <= -1) return 0;
  // Simpson's rule over the angle whose sine is y, in which the slices are smooth but at the circle's cut by x =
  // -along.
  constexpr int pieces = 32;
  const double first = std::asin(low), step = (std::asin(high) - first) / pieces;
  double sum = 0;
  for (int k = 0; k <= pieces; ++k) {
    const double angle = first + k * step, y = std::sin(angle), half = std::cos(angle);
    const double from = std::max(-along, -half);
    const double area = from < half ? slice(half, y) - slice(from, y) : 0;
    sum += (k == 0 || k == pieces ? 1 : k % 2 == 1 ? 4 : 2) * area * half;
  }
  return sum * step / 3 * (3 / std::numbers::pi);
}

const Cone& Cone::tables() {
  static const Cone tables;
  return tables;
}

Cone::Cone() {
  // An entry stands for its stretch by the value in its middle; the last one, beyond reach, is 0.
  for (std::size_t k = 0; k < entries; ++k) {
    const double across = (static_cast<double>(k) + 0.5) * reach / entries;
    strip_[k] = static_cast<std::uint8_t>(std::lround(full * cone_share(1, across)));
    for (std::size_t s = 0; s < entries; ++s) {
      ends_[s][k] = full * cone_share((static_cast<double>(s) + 0.5) * 2 / entries - 1, across);
    }
  }
}

double Cone::half(double along, double across) const {
  if (along >= 1) return endless(across);
  if (along < -1) return 0;
  if (across >= reach) return 0;
  return ends_[static_cast<std::size_t>((along + 1) * (entries / 2))]
              [static_cast<std::size_t>(across * (entries / reach))];
}

std::uint32_t Cone::between(double before, double after, double across) const {
  const double share = half(before, across) + half(after, across) - endless(across);
  return static_cast<std::uint32_t>(std::clamp<double>(share, 0, full) + 0.5);
}

}  // namespace scan_conversion
