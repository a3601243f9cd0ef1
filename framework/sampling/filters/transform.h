// Integrals over a filter's pieces.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include <boost/math/quadrature/gauss.hpp>

namespace moire {

// The integral of at(x) cos(2 pi f x) over all x, `at` even and smooth between its knots, by Gauss-Legendre quadrature:
// 15 points for each half pixel and half period, good to rounding.
template <class At>
double cosine_transform(At at, std::span<const double> knots, double frequency) {
  const double omega = 2 * std::numbers::pi * std::abs(frequency);
  const auto integrand = [&](double x) { return at(x) * std::cos(omega * x); };
  double sum = 0, from = 0;
  for (double knot : knots) {
    const int parts = static_cast<int>(std::ceil((knot - from) * 2 * std::max(1.0, std::abs(frequency))));
    for (int k = 0; k < parts; ++k) {
      const double a = from + (knot - from) * k / parts, b = from + (knot - from) * (k + 1) / parts;
      sum += boost::math::quadrature::gauss<double, 15>::integrate(integrand, a, b);
    }
    from = knot;
  }
  return 2 * sum;
}

}  // namespace moire
