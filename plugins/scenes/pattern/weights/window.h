// One axis of a filter, with its integral.
#pragma once

#include <span>
#include <vector>

#include <moire/filter.h>
#include <moire/geometry.h>

#include "weights/piecewise.h"

namespace pattern {

// Of any colour that comes from weights by quadrature: tests find a hundredth of it.
inline constexpr double quadrature_error = 1e-9;

class Window {
 public:
  static constexpr bool is_positive = false;
  static constexpr bool is_nothing(double weight) { return weight == 0; }

  // Keeps a reference.
  explicit Window(const moire::Filter& filter);

  double radius() const { return filter_.radius(); }
  double at(double x) const { return filter_.at(x); }
  // The integral of at() up to x.
  double below(double x) const;
  // From -radius() to radius(): places between which at() is smooth, and few enough to be a polynomial's piece.
  std::span<const double> breaks() const { return breaks_; }

  // The integral of f(x) at(x - middle) over x in `parts` parts between breaks, of no more than `length` pixels.
  template <class F>
  auto average(F f, double middle, double length) const;

  // Of the window about (0, 0): the integral of below(x) at(y) dy along the straight line from p to q. Around a
  // polygon, the sum is the polygon's weight (Green), positive if it turns from x to y.
  double along(moire::Point p, moire::Point q) const;
  // The weight of the half-plane where a x + b y + s > 0. Requires: a, b >= 0, not both 0.
  double half_plane(double a, double b, double s) const;
  // The weight of a disk.
  double disk(moire::Point middle, double radius) const;

 private:
  const moire::Filter& filter_;
  std::vector<double> breaks_;
  Piecewise below_;
};

}  // namespace pattern

#include "weights/quadrature.h"

namespace pattern {

template <class F>
auto Window::average(F f, double middle, double length) const {
  decltype(f(middle)) sum = 0;
  for (std::size_t k = 0; k + 1 < breaks_.size(); ++k) {
    const double from = breaks_[k], to = breaks_[k + 1];
    sum += integral([&](double t) { return f(middle + t) * at(t); }, from, to, parts_of(from, to, length));
  }
  return sum;
}

}  // namespace pattern
