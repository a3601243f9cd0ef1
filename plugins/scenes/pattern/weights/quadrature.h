// Gauss-Legendre quadrature.
#pragma once

#include <cmath>

#include <boost/math/quadrature/gauss.hpp>

namespace pattern {

// The integral of f from a to b in `parts` equal parts, 15 points each: of a sinusoid, 4e-17 of its amplitude for
// each part of up to 2 periods.
template <class F>
auto integral(F f, double a, double b, int parts = 1) {
  decltype(f(a)) sum = 0;
  for (int k = 0; k < parts; ++k) {
    const double from = a + (b - a) * k / parts, to = a + (b - a) * (k + 1) / parts;
    if (from < to) sum += boost::math::quadrature::gauss<double, 15>::integrate(f, from, to);
  }
  return sum;
}

// How many parts of about `length` there are from a to b.
inline int parts_of(double a, double b, double length) { return 1 + static_cast<int>((b - a) / length); }

}  // namespace pattern
