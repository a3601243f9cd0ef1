#include "plugins/primitives/brute_force.h"

#include <algorithm>
#include <cmath>

#include <moire/random.h>

namespace moire::test {

namespace {

long double depth_in(const LineCurve& line, Point p) {
  const long double half = line.width / 2.0L, dx = static_cast<long double>(line.to.x) - line.from.x,
                    dy = static_cast<long double>(line.to.y) - line.from.y;
  const long double px = static_cast<long double>(p.x) - line.from.x, py = static_cast<long double>(p.y) - line.from.y;
  const long double length = std::hypot(dx, dy);
  const long double ux = length > 0 ? dx / length : 1, uy = length > 0 ? dy / length : 0;
  const long double along = px * ux + py * uy, aside = std::abs(ux * py - uy * px);
  if (line.cap == Cap::round) {
    const long double beyond = std::max({-along, along - length, 0.0L});
    return half - std::hypot(beyond, aside);
  }
  const long double longer = line.cap == Cap::square ? half : 0;
  return std::min({half - aside, along + longer, length + longer - along});
}

long double depth_in(const CircleCurve& circle, Point p) {
  const long double x = static_cast<long double>(p.x) - circle.center.x,
                    y = static_cast<long double>(p.y) - circle.center.y;
  return circle.width / 2.0L - std::abs(std::hypot(x, y) - circle.radius);
}

}  // namespace

long double depth(const primitives::Curve& curve, Point p) {
  return std::visit([&](const auto& c) { return depth_in(c, p); }, curve);
}

std::optional<Element> seen_at(const std::vector<primitives::Curve>& curves, Point p, long double unsure) {
  for (std::size_t k = curves.size(); k-- > 0;) {
    const long double inside = depth(curves[k], p);
    // What covers no area has its outline everywhere, and is never seen.
    const bool is_thin = std::visit([](const auto& c) { return c.width == 0; }, curves[k]);
    if (is_thin) continue;
    if (std::abs(inside) < unsure) return std::nullopt;
    if (inside > 0) return std::visit([](const auto& c) { return c.element; }, curves[k]);
  }
  return background;
}

std::vector<primitives::Curve> random_curves(int count, ImageSize size, std::uint64_t seed) {
  std::vector<primitives::Curve> curves;
  for (int k = 0; k < count; ++k) {
    const auto draw = [&](std::uint32_t dimension) { return random({.x = k, .seed = seed}, 0, dimension); };
    const double extent = std::max(size.width, size.height);
    const Element element = static_cast<Element>(k) + 1;
    const Color color{static_cast<float>(draw(0)), static_cast<float>(draw(1)), 0.5F};
    const Point p{(1.4 * draw(2) - 0.2) * size.width, (1.4 * draw(3) - 0.2) * size.height};
    // Mostly thin, some wide.
    double width = extent * std::pow(draw(4), 6);
    double reach = extent * draw(5) * draw(5);
    if (k % 11 == 7) width = 0;
    if (k % 13 == 5) reach = 0;
    if (k % 3 == 0) {
      curves.push_back(CircleCurve{element, color, p, reach, width});
      continue;
    }
    const double angle = k % 5 == 0 ? std::floor(8 * draw(6)) / 8 : draw(6);
    const double dx = std::cos(6.283185307179586 * angle), dy = std::sin(6.283185307179586 * angle);
    Point q{p.x + reach * dx, p.y + reach * dy};
    if (k % 5 == 0 && std::abs(dx) < 1e-9) q.x = p.x;
    if (k % 5 == 0 && std::abs(dy) < 1e-9) q.y = p.y;
    curves.push_back(LineCurve{element, color, p, q, width, static_cast<Cap>(k % 4 % 3)});
  }
  return curves;
}

std::unique_ptr<Frame> frame_of(std::vector<primitives::Curve> curves, ImageSize size, double tolerance) {
  return std::make_unique<primitives::PrimitivesFrame>(std::move(curves), size, Color{1, 1, 1}, tolerance);
}

std::vector<Element> elements_at(const Frame& frame, const std::vector<Point>& points) {
  std::vector<SamplePoint> samples;
  for (const Point p : points) samples.push_back({p.x, p.y});
  std::vector<Hit> hits(points.size());
  Counters counters;
  frame.trace(samples, hits, counters);
  std::vector<Element> elements;
  for (const Hit& hit : hits) elements.push_back(hit.element);
  return elements;
}

}  // namespace moire::test
