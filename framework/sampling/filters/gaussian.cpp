// The Gaussian. Maddock's h(u, v) integrates to 1/2: its exponent lacks a 2.
#include <cmath>
#include <numbers>

#include "sampling/filters.h"
#include "sampling/filters/transform.h"

namespace moire {

namespace {

constexpr double cut = 4;  // standard deviations; 6e-5 of the weight lies beyond, which the rest makes up for

class Gaussian final : public Filter {
 public:
  explicit Gaussian(double sigma)
      : sigma_(sigma),
        radius_(cut * sigma),
        peak_(1 / (sigma * std::sqrt(2 * std::numbers::pi) * std::erf(cut / std::numbers::sqrt2))) {}
  double radius() const override { return radius_; }
  double at(double x) const override {
    return std::abs(x) < radius_ ? peak_ * std::exp(-x * x / (2 * sigma_ * sigma_)) : 0;
  }
  double transfer(double frequency) const override {
    return cosine_transform([this](double x) { return at(x); }, knots(), frequency);
  }
  std::span<const double> knots() const override { return {&radius_, 1}; }

 private:
  double sigma_, radius_, peak_;
};

}  // namespace

std::unique_ptr<Filter> make_gaussian(double sigma) { return std::make_unique<Gaussian>(sigma); }

}  // namespace moire
