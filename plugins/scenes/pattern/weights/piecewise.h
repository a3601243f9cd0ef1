// A function that is smooth between breaks, kept as polynomials.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

namespace pattern {

class Piecewise {
 public:
  Piecewise() = default;
  // `breaks` rise. Between two of them `f` is interpolated in Chebyshev's points.
  template <class F>
  Piecewise(std::span<const double> breaks, F f) : breaks_(breaks.begin(), breaks.end()) {
    breaks_.erase(std::unique(breaks_.begin(), breaks_.end()), breaks_.end());
    for (std::size_t k = 0; k + 1 < breaks_.size(); ++k) pieces_.push_back(fitted(breaks_[k], breaks_[k + 1], f));
  }

  // Requires: x from the first break to the last.
  double operator()(double x) const {
    const auto above = std::upper_bound(breaks_.begin() + 1, breaks_.end() - 1, x);
    const auto k = static_cast<std::size_t>(above - breaks_.begin()) - 1;
    const double t = 2 * ((x - breaks_[k]) / (breaks_[k + 1] - breaks_[k])) - 1;
    // Clenshaw's recurrence.
    double b1 = 0, b2 = 0;
    for (std::size_t j = terms - 1; j > 0; --j) {
      const double b0 = 2 * t * b1 - b2 + pieces_[k][j];
      b2 = b1, b1 = b0;
    }
    return t * b1 - b2 + pieces_[k][0];
  }

 private:
  static constexpr std::size_t terms = 16;
  using Coefficients = std::array<double, terms>;

  template <class F>
  static Coefficients fitted(double from, double to, F f) {
    std::array<double, terms> values;
    const auto angle = [](std::size_t i) { return std::numbers::pi * (static_cast<double>(i) + 0.5) / terms; };
    for (std::size_t i = 0; i < terms; ++i) values[i] = f(from + (to - from) * (0.5 + 0.5 * std::cos(angle(i))));
    Coefficients result{};
    for (std::size_t j = 0; j < terms; ++j) {
      for (std::size_t i = 0; i < terms; ++i) result[j] += values[i] * std::cos(static_cast<double>(j) * angle(i));
      result[j] *= (j == 0 ? 1.0 : 2.0) / terms;
    }
    return result;
  }

  std::vector<double> breaks_;
  std::vector<Coefficients> pieces_;
};

}  // namespace pattern
