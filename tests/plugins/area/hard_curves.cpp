#include "hard_curves.h"

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "support/hard_pixels/sketch.h"

namespace moire::test {

namespace {

using hard::Chance;

// Curves about the pixel [0, 1) x [0, 1).
class Sketch {
 public:
  explicit Sketch(Chance chance_given) : chance(chance_given) {}

  Chance chance;
  std::vector<Curve> curves;

  Cap cap() { return static_cast<Cap>(chance.whole(0, 2)); }
  Point inside() { return chance.point(0, 1); }
  double angle() { return chance.between(0, 2 * std::numbers::pi); }
  static Point beside(Point p, double direction, double distance) {
    return {p.x + distance * std::cos(direction), p.y + distance * std::sin(direction)};
  }
  void line(Point from, Point to, double width, Cap cap) { curves.push_back(LineCurve{0, {}, from, to, width, cap}); }
  void circle(Point center, double radius, double width) {
    curves.push_back(CircleCurve{0, {}, center, radius, width});
  }
  // Through a point, far beyond the pixel both ways.
  void line_through(Point p, double direction, double width) {
    line(beside(p, direction, -chance.between(2, 30)), beside(p, direction, chance.between(2, 30)), width, cap());
  }
  void any_line() { line_through(inside(), angle(), chance.between(0.05, 1.5)); }
  void any_circle() {
    const double radius = chance.one_in(2) ? chance.between(0.05, 2) : chance.between(2, 300);
    circle(beside(inside(), angle(), radius), radius, chance.between(0.05, 1.5));
  }
  void any() { chance.one_in(2) ? any_line() : any_circle(); }
};

struct Kind {
  std::string_view name;
  void (*draw)(Sketch&);
};

constexpr std::array all{
    Kind{"lines",
         [](Sketch& s) {
           for (int k = s.chance.whole(2, 4); k > 0; --k) s.any_line();
         }},
    Kind{"circles",
         [](Sketch& s) {
           for (int k = s.chance.whole(2, 4); k > 0; --k) s.any_circle();
         }},
    Kind{"lines and circles",
         [](Sketch& s) {
           for (int k = s.chance.whole(2, 7); k > 0; --k) s.any();
         }},
    Kind{"ends of lines",
         [](Sketch& s) {
           for (int k = s.chance.whole(2, 4); k > 0; --k) {
             s.line(s.inside(), s.chance.point(-1, 2), s.chance.between(0.05, 1), s.cap());
           }
         }},
    Kind{"one line with round caps",
         [](Sketch& s) { s.line(s.inside(), s.chance.point(-1, 2), s.chance.between(0.05, 3), Cap::round); }},
    Kind{"lines that share an end point",
         [](Sketch& s) {
           const Point p = s.inside();
           for (int k = s.chance.whole(2, 6); k > 0; --k) {
             s.line(p, s.chance.point(-2, 3), s.chance.between(0.05, 0.6), s.cap());
           }
         }},
    Kind{"tangent circles",
         [](Sketch& s) {
           // From within, from without, or off by rounding errors, with their outer edges.
           const Point p = s.inside();
           const double direction = s.angle(), width = s.chance.between(0.05, 0.5);
           for (int k = s.chance.whole(2, 3); k > 0; --k) {
             const double radius = s.chance.between(0.3, 20), side = s.chance.one_in(2) ? 1 : -1;
             s.circle(Sketch::beside(p, direction, side * (radius + width / 2)), radius,
                      s.chance.one_in(3) ? width + s.chance.tiny(1e-15, 1e-3) : width);
           }
         }},
    Kind{"lines tangent to circles",
         [](Sketch& s) {
           const Point p = s.inside();
           const double direction = s.angle(), radius = s.chance.between(0.2, 50), width = s.chance.between(0.05, 0.5);
           s.circle(Sketch::beside(p, direction, radius + width / 2), radius, width);
           s.line_through(Sketch::beside(p, direction, s.chance.one_in(2) ? -width / 2 : width / 2),
                          direction + std::numbers::pi / 2, width);
           if (s.chance.one_in(2)) std::swap(s.curves[0], s.curves[1]);
         }},
    Kind{"concentric rings",
         [](Sketch& s) {
           const Point p = s.chance.one_in(2) ? s.inside() : s.chance.point(-40, 40);
           double radius = std::hypot(p.x, p.y);
           for (int k = s.chance.whole(2, 6); k > 0; --k) {
             const double width = s.chance.between(0.05, 0.4);
             s.circle(p, radius, width);
             radius += s.chance.one_in(2) ? width : s.chance.between(0, width);
           }
         }},
    Kind{"coincident edges",
         [](Sketch& s) {
           // Lines of one direction whose strips touch, and some across.
           const Point p = s.inside();
           const double direction = s.angle();
           double at = 0;
           for (int k = s.chance.whole(2, 5); k > 0; --k) {
             const double width = 0.125 * s.chance.whole(1, 4);
             s.line_through(Sketch::beside(p, direction + std::numbers::pi / 2, at + width / 2), direction, width);
             at += width;
           }
           if (s.chance.one_in(2)) s.any();
         }},
    Kind{"crossings on the pixel's border",
         [](Sketch& s) {
           const Point p = s.chance.one_in(2) ? Point{s.chance.whole(0, 1) + 0.0, s.chance.whole(0, 4) / 4.0}
                                              : Point{s.chance.whole(0, 4) / 4.0, s.chance.whole(0, 1) + 0.0};
           for (int k = s.chance.whole(2, 5); k > 0; --k) {
             // Edges through p, of steps of an eighth.
             const double width = 0.125 * s.chance.whole(1, 8), direction = s.angle();
             if (s.chance.one_in(3)) {
               const double radius = s.chance.between(0.2, 9);
               s.circle(Sketch::beside(p, direction, radius + width / 2), radius, width);
             } else {
               s.line_through(Sketch::beside(p, direction + std::numbers::pi / 2, width / 2), direction, width);
             }
           }
         }},
    Kind{"duplicates",
         [](Sketch& s) {
           for (int k = s.chance.whole(1, 3); k > 0; --k) {
             s.any();
             for (int n = s.chance.whole(1, 3); n > 0; --n) s.curves.push_back(s.curves.back());
           }
           if (s.chance.one_in(2)) std::swap(s.curves.front(), s.curves.back());
         }},
    Kind{"edges along the pixel's sides",
         [](Sketch& s) {
           for (int k = s.chance.whole(2, 5); k > 0; --k) {
             const double width = 0.25 * s.chance.whole(1, 6), side = s.chance.whole(0, 1);
             const double at = s.chance.one_in(2) ? side + width / 2 : side - width / 2;
             const double from = s.chance.one_in(3) ? 0.25 : -3, to = s.chance.one_in(3) ? 0.75 : 4;
             s.chance.one_in(2) ? s.line({from, at}, {to, at}, width, s.cap())
                                : s.line({at, from}, {at, to}, width, s.cap());
           }
           if (s.chance.one_in(2)) s.any();
         }},
    Kind{"nearly parallel lines",
         [](Sketch& s) {
           const Point p = s.inside();
           const double direction = s.chance.one_in(3) ? s.chance.whole(0, 3) * std::numbers::pi / 2 : s.angle();
           for (int k = s.chance.whole(2, 6); k > 0; --k) {
             s.line_through(Sketch::beside(p, direction + std::numbers::pi / 2, s.chance.tiny(1e-12, 0.1)),
                            direction + s.chance.tiny(1e-13, 1e-2), 0.125 * s.chance.whole(1, 6));
           }
         }},
    Kind{"nearly equal circles",
         [](Sketch& s) {
           const double radius = s.chance.between(0.3, 100), direction = s.angle();
           const Point p = Sketch::beside(s.inside(), direction, radius);
           for (int k = s.chance.whole(2, 5); k > 0; --k) {
             s.circle({p.x + s.chance.tiny(1e-13, 1e-2), p.y + s.chance.tiny(1e-13, 1e-2)},
                      radius + s.chance.tiny(1e-13, 1e-2), 0.125 * s.chance.whole(1, 4));
           }
         }},
    Kind{"dots and small rings",
         [](Sketch& s) {
           for (int k = s.chance.whole(2, 6); k > 0; --k) {
             s.circle(s.inside(), s.chance.one_in(3) ? 0 : s.chance.between(0, 0.3), s.chance.between(0.02, 0.5));
           }
         }},
    Kind{"forty of them",
         [](Sketch& s) {
           for (int k = 40; k > 0; --k) {
             s.any();
             if (auto* made = std::get_if<LineCurve>(&s.curves.back())) made->width *= 0.1;
             if (auto* made = std::get_if<CircleCurve>(&s.curves.back())) made->width *= 0.1;
           }
         }},
    Kind{"a fan of thirty lines",
         [](Sketch& s) {
           const Point p = s.chance.one_in(2) ? Point{.5, .5} : s.inside();
           const double width = s.chance.one_in(2) ? 0.002 : 0.1;
           for (int k = 0; k < 30; ++k) {
             s.line(p, Sketch::beside(p, k * std::numbers::pi / 15, 5), width,
                    s.chance.one_in(4) ? s.cap() : Cap::butt);
           }
         }},
};

}  // namespace

std::span<const std::string_view> hard_curve_kinds() {
  static constexpr auto names = [] {
    std::array<std::string_view, all.size()> result;
    for (std::size_t k = 0; k < all.size(); ++k) result[k] = all[k].name;
    return result;
  }();
  return names;
}

HardCurves hard_curves(std::string_view kind, std::uint64_t seed) {
  for (const Kind& candidate : all) {
    if (candidate.name != kind) continue;
    Sketch sketch{Chance(seed)};
    candidate.draw(sketch);
    // Somewhere in an image.
    HardCurves made{sketch.chance.whole(0, 9), sketch.chance.whole(0, 9), std::move(sketch.curves)};
    Element element = 0;
    const auto moved = [&](Point& p) { p = {p.x + made.x, p.y + made.y}; };
    for (Curve& curve : made.curves) {
      ++element;
      if (auto* line = std::get_if<LineCurve>(&curve)) {
        line->element = element, moved(line->from), moved(line->to);
      } else {
        auto& circle = std::get<CircleCurve>(curve);
        circle.element = element, moved(circle.center);
      }
    }
    return made;
  }
  throw std::logic_error("hard_curves: no kind " + std::string(kind));
}

}  // namespace moire::test
