// Patterns of dark and light parts: exact areas in pixels, or weights under a filter.
#pragma once

#include <algorithm>

#include "frame.h"
#include "weights/square.h"
#include "weights/window.h"

namespace pattern {

// `Kind` has `void cover(const Weights&, PixelBlock&) const` for both Square and Window.
template <class Kind>
class TwoValued : public PatternFrame<Kind> {
 public:
  using PatternFrame<Kind>::PatternFrame;

 protected:
  double integrate(const moire::Filter* filter, moire::PixelBlock& block) const override {
    const Kind& kind = static_cast<const Kind&>(*this);
    if (!filter) {
      kind.cover(Square(), block);
      return 0;
    }
    kind.cover(Window(*filter), block);
    return quadrature_error;
  }
};

// The weights of half-planes of one direction: where g.p + s > 0, p from the pixel's middle.
template <class Weights>
class HalfPlanes;

template <>
class HalfPlanes<Square> {
 public:
  HalfPlanes(const Square&, moire::Point gradient) : a_(std::abs(gradient.x)), b_(std::abs(gradient.y)) {}
  // From here on they hold all of the pixel, and below the negative of it none.
  double reach() const { return Square::radius() * (a_ + b_); }
  double operator()(double s) const { return Square::half_plane(a_, b_, s); }

 private:
  double a_, b_;
};

template <>
class HalfPlanes<Window> {
 public:
  HalfPlanes(const Window& window, moire::Point gradient) {
    const double a = std::abs(gradient.x), b = std::abs(gradient.y);
    reach_ = window.radius() * (a + b);
    if (reach_ == 0) return;
    // Smooth but where the line goes through a place where breaks of both axes meet.
    std::vector<double> breaks;
    for (const double x : window.breaks()) {
      for (const double y : window.breaks()) breaks.push_back(a * x + b * y);
    }
    std::sort(breaks.begin(), breaks.end());
    weights_ = Piecewise(breaks, [&](double s) { return window.half_plane(a, b, s); });
  }
  double reach() const { return reach_; }
  double operator()(double s) const { return s <= -reach_ ? 0 : s >= reach_ ? 1 : weights_(s); }

 private:
  double reach_;
  Piecewise weights_;
};

}  // namespace pattern
