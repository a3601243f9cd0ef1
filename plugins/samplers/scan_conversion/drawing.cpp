#include "drawing.h"

#include <algorithm>
#include <limits>

#include "lines/reach.h"

namespace scan_conversion {

namespace {

// Pixels that a method may light beside a curve: two of its own, and what a float rounds.
float below(double x) { return static_cast<float>(x - 3 - std::abs(x) * 0x1p-22); }
float above(double x) { return static_cast<float>(x + 3 + std::abs(x) * 0x1p-22); }

bool is_within(const moire::CircleCurve& circle) {
  return circle.radius >= 0 && circle.radius <= farthest && std::abs(circle.center.x) <= farthest &&
         std::abs(circle.center.y) <= farthest;
}

}  // namespace

Drawing::Drawing(const moire::Curves& curves) : background_(curves.background_color()) {
  struct Sink final : moire::CurveSink {
    explicit Sink(Drawing& owner) : drawing(owner) {}

    void line(const moire::LineCurve& line) override {
      const auto ends = within_reach(line.from, line.to);
      if (!ends) return;
      const auto [a, b] = *ends;
      drawing.strokes_.push_back({line.element, line.color, false, a, b, {}, 0});
      drawing.boxes_.push_back(
          {below(std::min(a.x, b.x)), below(std::min(a.y, b.y)), above(std::max(a.x, b.x)), above(std::max(a.y, b.y))});
    }
    void circle(const moire::CircleCurve& circle) override {
      if (!is_within(circle)) return;
      const auto [x, y] = circle.center;
      drawing.strokes_.push_back({circle.element, circle.color, true, {}, {}, {x, y}, circle.radius});
      drawing.boxes_.push_back(
          {below(x - circle.radius), below(y - circle.radius), above(x + circle.radius), above(y + circle.radius)});
    }
    Drawing& drawing;
  } sink(*this);
  curves.stream(sink);
}

}  // namespace scan_conversion
