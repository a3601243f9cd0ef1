#include "support/hard_pixels/thousand_layers.h"

#include <array>

namespace moire::test::hard {

namespace {

constexpr int thousand = 1000;

void thousand_strips(Sketch& sketch) {
  const double lean = sketch.chance.between(-1, 1);
  for (int k = 0; k < thousand; ++k) {
    const double x0 = -lean + (1 + 2 * lean) * k / thousand, x1 = -lean + (1 + 2 * lean) * (k + 1) / thousand;
    sketch.add({{{x0, -0.25}, {x1, -0.25}, {x1 + lean, 1.25}, {x0 + lean, 1.25}}});
  }
}

void thousand_nested(Sketch& sketch) {
  const Point middle = sketch.chance.point(0.3, 0.7);
  const int corners = sketch.chance.whole(3, 5);
  const double angle = sketch.chance.between(0, 6.28);
  // Ten layers of each size: rational numbers take their time.
  for (int k = 0; k < thousand; ++k) sketch.add({star(middle, 0.01 * (k / 10 + 1), corners, 1, angle)});
}

void thousand_scattered(Sketch& sketch) {
  for (int k = 0; k < thousand; ++k) {
    const Point p = sketch.chance.point(0, 1);
    sketch.add({star(p, sketch.chance.between(0.001, 0.04), 3, 1, sketch.chance.between(0, 6.28))});
  }
}

// All have a corner in common, and each shares an edge with the next.
void thousand_in_a_fan(Sketch& sketch) {
  const Point middle = sketch.chance.point(0, 1);
  const Contour rim = star(middle, 2, thousand, 1, sketch.chance.unit());
  for (std::size_t k = 0; k < thousand; ++k) sketch.add({{middle, rim[k], rim[(k + 1) % thousand]}});
}

// Few are seen, if any, of those behind the first.
void thousand_duplicates(Sketch& sketch) {
  const Contour original = sketch.any_contour(5);
  for (int k = 0; k < thousand; ++k) {
    Contour contour = original;
    if (k % 7 == 0) contour[0].x += sketch.chance.tiny(1e-14, 1e-12);
    sketch.add({std::move(contour)});
  }
}

}  // namespace

void thousand_layers(Sketch& sketch) {
  constexpr std::array makes{thousand_strips, thousand_nested, thousand_scattered, thousand_in_a_fan,
                             thousand_duplicates};
  makes[static_cast<std::size_t>(sketch.chance.whole(0, static_cast<int>(makes.size()) - 1))](sketch);
  sketch.add_ground();
}

}  // namespace moire::test::hard
