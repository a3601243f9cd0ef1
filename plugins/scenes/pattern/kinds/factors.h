// The functions along one axis that blobs and zone plates are products of, and their averages about a pixel's middle.
#pragma once

#include <cmath>
#include <complex>
#include <numbers>

#include "weights/window.h"

namespace pattern {

// exp(-x^2 / (2 sigma^2)).
class Gaussian {
 public:
  explicit Gaussian(double sigma) : sigma_(sigma) {}

  double at(double x) const { return std::exp(-x * x / (2 * sigma_ * sigma_)); }
  double over_pixel(double middle) const {
    const double scale = 1 / (sigma_ * std::numbers::sqrt2);
    return std::sqrt(std::numbers::pi) / 2 / scale *
           (std::erf(scale * (middle + 0.5)) - std::erf(scale * (middle - 0.5)));
  }
  double under(const Window& window, double middle) const {
    return window.average([this](double x) { return at(x); }, middle, 2 * sigma_);
  }

 private:
  double sigma_;
};

// e^(i pi rate x^2): its frequency is rate x, cycles a pixel. Averages are Fresnel integrals, by quadrature.
class Chirp {
 public:
  explicit Chirp(double rate) : rate_(rate) {}

  double rate() const { return rate_; }
  std::complex<double> at(double x) const { return std::polar(1.0, std::numbers::pi * rate_ * x * x); }
  std::complex<double> over_pixel(double middle) const {
    const double highest = rate_ * (std::abs(middle) + 0.5);
    return integral([this](double x) { return at(x); }, middle - 0.5, middle + 0.5, parts_of(0, highest, 1));
  }
  std::complex<double> under(const Window& window, double middle) const {
    const double highest = rate_ * (std::abs(middle) + window.radius());
    return window.average([this](double x) { return at(x); }, middle, 1 / highest);
  }

 private:
  double rate_;
};

}  // namespace pattern
