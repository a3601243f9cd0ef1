#include "pixels/tile_rule.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace shadow_planes {

namespace {

// P_0 .. P_n of Legendre at x.
std::vector<double> legendre(int n, double x) {
  std::vector<double> p{1, x};
  for (int k = 1; k < n; ++k) {
    const auto i = static_cast<std::size_t>(k);
    p.push_back(((2 * k + 1) * x * p[i] - k * p[i - 1]) / (k + 1));
  }
  return p;
}

}  // namespace

TileRule::TileRule(int points, int side) : points_(points), side_(side) {
  const auto n = static_cast<std::size_t>(points);
  std::vector<double> x(n), weight(n);
  for (std::size_t i = 0; i < n; ++i) {
    // Newton's steps from Tricomi's estimate; the slope from P_n and P_(n-1).
    x[i] = -std::cos(std::numbers::pi * (static_cast<double>(i) + 0.75) / (points + 0.5));
    double slope = 1;
    for (int step = 0; step < 10; ++step) {
      const std::vector<double> p = legendre(points, x[i]);
      slope = points * (x[i] * p[n] - p[n - 1]) / (x[i] * x[i] - 1);
      x[i] -= p[n] / slope;
    }
    weight[i] = 2 / ((1 - x[i] * x[i]) * slope * slope);
    at_.push_back(side * (1 + x[i]) / 2);
  }
  // Coefficients by the rule itself, exact up to degree 2 n - 1.
  coefficients_.resize(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::vector<double> p = legendre(points, x[i]);
    for (std::size_t k = 0; k < n; ++k) coefficients_[k * n + i] = (static_cast<double>(k) + 0.5) * weight[i] * p[k];
  }
  // The integral of P_k is (P_(k+1) - P_(k-1)) / (2 k + 1).
  const auto integral = [&](std::size_t k, double from, double to) {
    if (k == 0) return to - from;
    const std::vector<double> a = legendre(points, from), b = legendre(points, to);
    return ((b[k + 1] - b[k - 1]) - (a[k + 1] - a[k - 1])) / static_cast<double>(2 * k + 1);
  };
  for (int pixel = 0; pixel < side; ++pixel) {
    const double from = 2.0 * pixel / side - 1, to = 2.0 * (pixel + 1) / side - 1;
    for (std::size_t i = 0; i < n; ++i) {
      double sum = 0;
      for (std::size_t k = 0; k < n; ++k) sum += coefficients_[k * n + i] * integral(k, from, to);
      pixel_weights_.push_back(sum / (to - from));
    }
  }
}

void TileRule::averages(std::span<const double> values, std::span<double> averages) const {
  const auto n = static_cast<std::size_t>(points_), side = static_cast<std::size_t>(side_);
  std::array<double, 16 * 8> across;  // [row of points][pixel]
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t x = 0; x < side; ++x) {
      double sum = 0;
      for (std::size_t i = 0; i < n; ++i) sum += pixel_weights_[x * n + i] * values[j * n + i];
      across[j * side + x] = sum;
    }
  }
  for (std::size_t y = 0; y < side; ++y) {
    for (std::size_t x = 0; x < side; ++x) averages[y * side + x] = 0;
    for (std::size_t j = 0; j < n; ++j) {
      const double weight = pixel_weights_[y * n + j];
      for (std::size_t x = 0; x < side; ++x) averages[y * side + x] += weight * across[j * side + x];
    }
  }
}

double TileRule::error(std::span<const double> values, bool is_smooth) const {
  const auto n = static_cast<std::size_t>(points_);
  std::array<double, 64> along{};
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t i = 0; i < n; ++i) along[j * n + k] += coefficients_[k * n + i] * values[j * n + i];
    }
  }
  // The largest coefficient of each degree, which is the larger of those along the two axes.
  std::array<double, 8> largest{};
  for (std::size_t l = 0; l < n; ++l) {
    for (std::size_t k = 0; k < n; ++k) {
      double sum = 0;
      for (std::size_t j = 0; j < n; ++j) sum += coefficients_[l * n + j] * along[j * n + k];
      largest[std::max(k, l)] = std::max(largest[std::max(k, l)], std::abs(sum));
    }
  }
  const double last = largest[n - 1], before = largest[n - 2], third = largest[n - 3];
  const auto fall = [](double from, double to) { return to < from ? to / from : from == 0 && to == 0 ? 0.0 : 1.0; };
  // Even or odd coefficients alone may be small: the slower of two steps counts.
  const double rate = is_smooth ? std::max(fall(before, last), fall(third, before)) : 1;
  return 2 * rate * std::max(last, rate * before);
}

const TileRule& tile_rule(int side) {
  static const std::array<TileRule, 4> rules{TileRule(4, 2), TileRule(5, 4), TileRule(6, 8), TileRule(7, 16)};
  return rules[side == 2 ? 0 : side == 4 ? 1 : side == 8 ? 2 : 3];
}

}  // namespace shadow_planes
