// Filters of tests, whose weights have closed forms.
#pragma once

#include <cmath>
#include <numbers>

#include <moire/filter.h>

namespace moire::test {

// The pixel's own square.
class BoxFilter final : public Filter {
 public:
  double radius() const override { return radius_; }
  double at(double x) const override { return std::abs(x) < radius_ ? 1 : 0; }
  double transfer(double frequency) const override {
    const double angle = std::numbers::pi * frequency;
    return angle == 0 ? 1 : std::sin(angle) / angle;
  }
  std::span<const double> knots() const override { return {&radius_, 1}; }

 private:
  double radius_ = 0.5;
};

// A Gaussian of which 1e-18 is cut off: isotropic.
class WideGaussian final : public Filter {
 public:
  explicit WideGaussian(double sigma) : sigma_(sigma) {
    for (int k = 1; k <= 9; ++k) knots_.push_back(k * sigma);
  }
  double radius() const override { return knots_.back(); }
  double at(double x) const override {
    return std::abs(x) < radius()
               ? std::exp(-x * x / (2 * sigma_ * sigma_)) / (sigma_ * std::sqrt(2 * std::numbers::pi))
               : 0;
  }
  double transfer(double frequency) const override {
    const double angle = 2 * std::numbers::pi * frequency * sigma_;
    return std::exp(-angle * angle / 2);
  }
  std::span<const double> knots() const override { return knots_; }

 private:
  double sigma_;
  std::vector<double> knots_;
};

}  // namespace moire::test
