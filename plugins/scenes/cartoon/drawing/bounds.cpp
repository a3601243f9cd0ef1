#include "bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace cartoon {

namespace {

using moire::Point;

// One coordinate's least and largest value.
struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }

  // Where the derivative, a quadratic with control values d0, d1, d2 in Bernstein's form, is 0.
  void add_cubic(double p0, double p1, double p2, double p3) {
    const double d0 = p1 - p0, d1 = p2 - p1, d2 = p3 - p2;
    const double a = d0 - 2 * d1 + d2, b = d1 - d0;
    const auto at = [&](double t) {
      if (!(t > 0 && t < 1)) return;
      const double s = 1 - t;
      add(s * s * s * p0 + 3 * s * s * t * p1 + 3 * s * t * t * p2 + t * t * t * p3);
    };
    const double root = std::sqrt(std::max(b * b - a * d0, 0.0)), q = -(b + std::copysign(root, b));
    at(q / a);  // neither infinite nor undefined places lie between 0 and 1
    at(d0 / q);
  }
  void add_quadratic(double p0, double p1, double p2) {
    const double t = (p0 - p1) / (p0 - 2 * p1 + p2), s = 1 - t;
    if (t > 0 && t < 1) add(s * s * p0 + 2 * s * t * p1 + t * t * p2);
  }
  // c + u cos t + v sin t is largest at t0 = atan2(v, u) and least half a turn on.
  void add_arc(double c, double u, double v, double a, double b) {
    const double reach = std::hypot(u, v), first = std::min(a, b), last = std::max(a, b);
    const double crest = std::atan2(v, u);
    for (int half = 0; half < 2; ++half) {
      const double t = crest + half * std::numbers::pi, turn = 2 * std::numbers::pi;
      if (t + turn * std::ceil((first - t) / turn) <= last) add(half == 0 ? c + reach : c - reach);
    }
  }
};

}  // namespace

std::optional<Box> bounds_of(const Drawing& drawing) {
  if (drawing.verbs.empty()) return std::nullopt;
  Range x, y;
  const Point* p = drawing.points.data();
  Point at;
  for (const Verb verb : drawing.verbs) {
    switch (verb) {
      case Verb::move:
      case Verb::line:
        break;
      case Verb::quadratic:
        x.add_quadratic(at.x, p[0].x, p[1].x);
        y.add_quadratic(at.y, p[0].y, p[1].y);
        break;
      case Verb::cubic:
        x.add_cubic(at.x, p[0].x, p[1].x, p[2].x);
        y.add_cubic(at.y, p[0].y, p[1].y, p[2].y);
        break;
      case Verb::arc:
        x.add_arc(p[0].x, p[1].x, p[2].x, p[3].x, p[3].y);
        y.add_arc(p[0].y, p[1].y, p[2].y, p[3].x, p[3].y);
        break;
    }
    p += points_of(verb);
    at = p[-1];
    x.add(at.x);
    y.add(at.y);
  }
  return Box{x.low, y.low, x.high - x.low, y.high - y.low};
}

}  // namespace cartoon
