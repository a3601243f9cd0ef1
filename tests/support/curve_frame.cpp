#include "support/curve_frame.h"

#include <algorithm>
#include <cmath>

namespace moire::test {

namespace {

bool holds(const LineCurve& line, Point p) {
  const double dx = line.to.x - line.from.x, dy = line.to.y - line.from.y, length = std::hypot(dx, dy);
  const double x = p.x - line.from.x, y = p.y - line.from.y, half = line.width / 2;
  const auto is_near = [&](Point end) { return std::hypot(p.x - end.x, p.y - end.y) <= half; };
  if (line.cap == Cap::round && (is_near(line.from) || is_near(line.to))) return true;
  if (length == 0) return line.cap == Cap::square && std::max(std::abs(x), std::abs(y)) <= half;
  const double along = (x * dx + y * dy) / length, across = (x * dy - y * dx) / length;
  const double before = line.cap == Cap::square ? half : 0;
  return std::abs(across) <= half && along >= -before && along <= length + before;
}

bool holds(const CircleCurve& circle, Point p) {
  return std::abs(std::hypot(p.x - circle.center.x, p.y - circle.center.y) - circle.radius) <= circle.width / 2;
}

}  // namespace

void CurveFrame::trace(std::span<const SamplePoint> points, std::span<Hit> hits, Counters& counters) const {
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Point p{points[k].x, points[k].y};
    const auto holds_p = [p](const auto& curve) { return holds(curve, p); };
    const auto front =
        std::find_if(curves_.rbegin(), curves_.rend(), [&](const Curve& curve) { return std::visit(holds_p, curve); });
    const auto hit_of = [](const auto& curve) { return Hit{curve.element, curve.color}; };
    hits[k] = front == curves_.rend() ? Hit{background, background_} : std::visit(hit_of, *front);
    ++counters.queries;
  }
}

void CurveFrame::stream(CurveSink& sink) const {
  for (const Curve& curve : curves_) {
    if (const auto* line = std::get_if<LineCurve>(&curve)) sink.line(*line);
    if (const auto* circle = std::get_if<CircleCurve>(&curve)) sink.circle(*circle);
  }
}

}  // namespace moire::test
