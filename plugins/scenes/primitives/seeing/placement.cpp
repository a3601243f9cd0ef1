#include "placement.h"

namespace primitives {

namespace {

using moire::Point;

Point moved(Point p, Point velocity, double time) { return {p.x + time * velocity.x, p.y + time * velocity.y}; }

Point turned(Point p, Point middle, const moire::Turn& turn) {
  const double x = p.x - middle.x, y = p.y - middle.y;
  return {middle.x + (turn.cosine * x - turn.sine * y), middle.y + (turn.sine * x + turn.cosine * y)};
}

moire::LineCurve at(moire::LineCurve line, const Motion& motion, double time) {
  const double angle = time * motion.spin_deg;
  if (angle != 0) {
    const Point middle{(line.from.x + line.to.x) / 2, (line.from.y + line.to.y) / 2};
    const moire::Turn turn = moire::turn_of(angle);
    line.from = turned(line.from, middle, turn);
    line.to = turned(line.to, middle, turn);
  }
  line.from = moved(line.from, motion.velocity, time);
  line.to = moved(line.to, motion.velocity, time);
  return line;
}

moire::CircleCurve at(moire::CircleCurve circle, const Motion& motion, double time) {
  circle.center = moved(circle.center, motion.velocity, time);
  return circle;
}

void show(moire::LineCurve& line, const View& view) {
  line.from = view(line.from);
  line.to = view(line.to);
}

void show(moire::CircleCurve& circle, const View& view) {
  circle.center = view(circle.center);
  circle.radius *= view.zoom;
}

}  // namespace

View view_of(const moire::Settings& settings, moire::ImageSize size) {
  return {size,
          {settings.real("view.x"), settings.real("view.y")},
          settings.real("view.zoom"),
          moire::turn_of(settings.real("view.rotation_deg")),
          settings.flag("scale_widths")};
}

std::vector<Curve> placed(const std::vector<Primitive>& primitives, double time, const View& view) {
  std::vector<Curve> curves;
  curves.reserve(primitives.size());
  for (const Primitive& primitive : primitives) {
    curves.push_back(std::visit(
        [&](const auto& curve) -> Curve {
          auto result = at(curve, primitive.motion, time);
          show(result, view);
          if (view.scale_widths) result.width *= view.zoom;
          result.element = curves.size() + 1;
          return result;
        },
        primitive.curve));
  }
  return curves;
}

}  // namespace primitives
