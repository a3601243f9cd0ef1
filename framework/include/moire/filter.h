// Filters: how much a point beside or in a pixel counts in it.
#pragma once

#include <span>

namespace moire {

// A separable filter: a point (x, y) from the pixel's middle, in pixels, has the weight at(x) at(y).
class Filter {
 public:
  virtual ~Filter() = default;
  // at() is 0 from here on, pixels.
  virtual double radius() const = 0;
  // Even, and its integral is 1. May be negative.
  virtual double at(double x) const = 0;
  // The Fourier transform of at(), real since at() is even: what is left of a sinusoid of `frequency` cycles a pixel.
  virtual double transfer(double frequency) const = 0;
  // Where at() or a derivative of it jumps, rising, in (0, radius]; smooth in between.
  virtual std::span<const double> knots() const = 0;
};

}  // namespace moire
