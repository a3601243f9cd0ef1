#include "weights/window.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pattern {

Window::Window(const moire::Filter& filter) : filter_(filter) {
  // Between knots, and at the middle: half each.
  double from = 0;
  for (const double knot : filter.knots()) {
    for (const double place : {from, from + (knot - from) / 2}) {
      breaks_.push_back(place);
      if (place > 0) breaks_.push_back(-place);
    }
    from = knot;
  }
  breaks_.push_back(from);
  breaks_.push_back(-from);
  std::sort(breaks_.begin(), breaks_.end());
  // What lies below each break, and from there on.
  std::vector<double> sums{0};
  const auto value = [this](double x) { return at(x); };
  for (std::size_t k = 1; k < breaks_.size(); ++k)
    sums.push_back(sums.back() + integral(value, breaks_[k - 1], breaks_[k]));
  below_ = Piecewise(breaks_, [&](double x) {
    const auto k = static_cast<std::size_t>(std::upper_bound(breaks_.begin(), breaks_.end() - 1, x) - breaks_.begin());
    return sums[k - 1] + integral(value, breaks_[k - 1], x);
  });
}

double Window::below(double x) const {
  if (x <= -radius()) return 0;
  if (x >= radius()) return 1;
  return below_(x);
}

double Window::along(moire::Point p, moire::Point q) const {
  const double dx = q.x - p.x, dy = q.y - p.y;
  if (dy == 0) return 0;
  // Where the line meets breaks of either axis.
  std::vector<double> cuts{0, 1};
  for (const double b : breaks_) {
    for (const double t : {(b - p.x) / dx, (b - p.y) / dy}) {
      if (t > 0 && t < 1) cuts.push_back(t);
    }
  }
  std::sort(cuts.begin(), cuts.end());
  const auto value = [&](double t) { return below(p.x + t * dx) * at(p.y + t * dy); };
  double sum = 0;
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    if (std::abs(p.y + (cuts[k] + cuts[k + 1]) / 2 * dy) < radius()) sum += integral(value, cuts[k], cuts[k + 1]);
  }
  return dy * sum;
}

double Window::half_plane(double a, double b, double s) const {
  if (a < b) std::swap(a, b);
  const double reach = radius() * (a + b);
  if (s <= -reach) return 0;
  if (s >= reach) return 1;
  // At each y, x > -(s + b y) / a; at() is even.
  std::vector<double> cuts(breaks_.begin(), breaks_.end());
  for (const double place : breaks_) {
    const double y = (a * place - s) / b;
    if (std::abs(y) < radius()) cuts.push_back(y);
  }
  std::sort(cuts.begin(), cuts.end());
  const auto value = [&](double y) { return at(y) * below((s + b * y) / a); };
  double sum = 0;
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) sum += integral(value, cuts[k], cuts[k + 1]);
  return sum;
}

double Window::disk(moire::Point middle, double r) const {
  const double nearest_x = std::max(std::abs(middle.x) - radius(), 0.0);
  const double nearest_y = std::max(std::abs(middle.y) - radius(), 0.0);
  if (std::hypot(nearest_x, nearest_y) >= r) return 0;
  if (std::hypot(std::abs(middle.x) + radius(), std::abs(middle.y) + radius()) <= r) return 1;
  // Around the disk (Green), between the places where it meets breaks of either axis.
  constexpr int sectors = 16;
  std::vector<double> cuts;
  for (int k = 0; k <= sectors; ++k) cuts.push_back(std::numbers::pi * (2.0 * k / sectors - 1));
  for (const double b : breaks_) {
    if (std::abs(b - middle.x) < r) {
      const double angle = std::acos((b - middle.x) / r);
      cuts.insert(cuts.end(), {angle, -angle});
    }
    if (std::abs(b - middle.y) < r) {
      const double angle = std::asin((b - middle.y) / r);
      cuts.insert(cuts.end(), {angle, std::copysign(std::numbers::pi, angle) - angle});
    }
  }
  std::sort(cuts.begin(), cuts.end());
  const auto x = [&](double angle) { return middle.x + r * std::cos(angle); };
  const auto y = [&](double angle) { return middle.y + r * std::sin(angle); };
  const auto value = [&](double angle) { return below(x(angle)) * at(y(angle)) * r * std::cos(angle); };
  double sum = 0;
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const double half_way = (cuts[k] + cuts[k + 1]) / 2;
    if (x(half_way) <= -radius() || std::abs(y(half_way)) >= radius()) continue;
    sum += x(half_way) >= radius() ? below(y(cuts[k + 1])) - below(y(cuts[k])) : integral(value, cuts[k], cuts[k + 1]);
  }
  return sum;
}

}  // namespace pattern
