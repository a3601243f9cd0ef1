#include "support/hard_pixels/simple_kinds.h"

#include <algorithm>
#include <array>

namespace moire::test::hard {

void shared_edges(Sketch& sketch) {
  const Point middle = sketch.chance.point(0, 1);
  const Contour rim = star(middle, sketch.chance.between(0.1, 3), sketch.chance.whole(3, 12), 1, sketch.chance.unit());
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const Point p = rim[i], q = rim[(i + 1) % rim.size()];
    // Some in two halves that share an edge more.
    if (sketch.chance.one_in(2)) {
      const Point between = at(p, q, 0.5);
      sketch.add({{middle, p, between}});
      sketch.add({{between, q, middle}});
    } else {
      sketch.add({{q, p, middle}});
    }
  }
  sketch.add_ground();
}

void coincident_edges(Sketch& sketch) {
  Chance& chance = sketch.chance;
  // Multiples of a power of two, whose points at eighths are on the line to the last digit, or any.
  const bool is_exact = chance.one_in(2);
  const auto on_grid = [&](Point p) {
    return is_exact ? Point{std::round(p.x * 64) / 64, std::round(p.y * 64) / 64} : p;
  };
  const Point from = on_grid(chance.point(-0.5, 1.5)), to = on_grid(chance.point(-0.5, 1.5));
  for (int k = chance.whole(2, 6); k > 0; --k) {
    const int begin = chance.whole(0, 7), end = chance.whole(begin + 1, 8);
    Contour contour{at(from, to, begin / 8.0), at(from, to, end / 8.0)};
    for (int more = chance.whole(1, 3); more > 0; --more) contour.push_back(on_grid(chance.point(-0.5, 1.5)));
    if (chance.one_in(2)) std::reverse(contour.begin(), contour.end());
    sketch.add({std::move(contour)});
  }
  sketch.add_ground();
}

void nearly_coincident_edges(Sketch& sketch) {
  Chance& chance = sketch.chance;
  const Contour original = sketch.any_contour(chance.whole(3, 5));
  const double largest = std::pow(10.0, chance.whole(-13, -6));
  for (int k = chance.whole(2, 6); k > 0; --k) {
    Contour contour = original;
    for (Point& p : contour) {
      if (chance.one_in(3)) continue;
      p = {p.x + chance.tiny(1e-14, largest), p.y + chance.tiny(1e-14, largest)};
    }
    sketch.add({std::move(contour)});
  }
  if (chance.one_in(2)) sketch.add({sketch.any_contour(3)});
  sketch.add_ground();
}

void corners_on_borders(Sketch& sketch) {
  Chance& chance = sketch.chance;
  for (int k = chance.whole(1, 5); k > 0; --k) {
    Contour contour = sketch.any_contour(chance.whole(3, 6));
    for (Point& p : contour) {
      for (double* value : {&p.x, &p.y}) {
        if (chance.one_in(3)) continue;
        *value = std::round(*value * 2) / 2;
        if (chance.one_in(8)) *value += chance.tiny(1e-15, 1e-9);
      }
    }
    sketch.add({std::move(contour)});
  }
  sketch.add_ground();
}

void slivers(Sketch& sketch) {
  Chance& chance = sketch.chance;
  constexpr double area = 1e-12;
  for (int k = chance.whole(1, 6); k > 0; --k) {
    const double length = std::exp(chance.between(std::log(1e-6), std::log(2.0)));
    const double angle = chance.one_in(3) ? chance.whole(0, 3) * std::numbers::pi / 2 : chance.between(0, 6.28);
    const Point p = chance.point(-0.2, 1.2), along{std::cos(angle), std::sin(angle)};
    const double width = 2 * area / length;
    const Point q{p.x + length * along.x, p.y + length * along.y};
    const Point tip = at(p, q, chance.unit());
    sketch.add({{p, q, {tip.x - width * along.y, tip.y + width * along.x}}});
  }
  // What they lie upon.
  if (chance.one_in(2)) sketch.add({sketch.any_contour(3)});
  sketch.add_ground();
}

void stacked_duplicates(Sketch& sketch) {
  Chance& chance = sketch.chance;
  const Contour original = sketch.any_contour(chance.whole(3, 7));
  for (int k = chance.whole(2, 30); k > 0; --k) {
    Contour contour = original;
    std::rotate(contour.begin(), contour.begin() + chance.whole(0, static_cast<int>(contour.size()) - 1),
                contour.end());
    if (chance.one_in(2)) std::reverse(contour.begin(), contour.end());
    sketch.add({std::move(contour)});
    if (chance.one_in(8)) sketch.add({sketch.any_contour(3)});
  }
  sketch.add_ground();
}

void self_intersections(Sketch& sketch) {
  Chance& chance = sketch.chance;
  for (int k = chance.whole(1, 3); k > 0; --k) {
    if (chance.one_in(2)) {
      const int corners = 2 * chance.whole(2, 5) + 1;
      sketch.add({star(chance.point(0, 1), chance.between(0.1, 1.5), corners, corners / 2, chance.between(0, 6.28))});
    } else {
      sketch.add({sketch.any_contour(chance.whole(4, 10))});
    }
  }
  sketch.add_ground();
}

void fill_rules(Sketch& sketch) {
  Chance& chance = sketch.chance;
  const Contour original = sketch.any_contour(chance.whole(3, 6));
  for (int k = chance.whole(1, 4); k > 0; --k) {
    std::vector<Contour> contours;
    for (int c = chance.whole(1, 4); c > 0; --c) {
      contours.push_back(chance.one_in(3) ? sketch.any_contour(chance.whole(3, 5)) : original);
      if (chance.one_in(2)) std::reverse(contours.back().begin(), contours.back().end());
    }
    sketch.add(std::move(contours));
  }
  sketch.add_ground();
}

void holes(Sketch& sketch) {
  Chance& chance = sketch.chance;
  for (int k = chance.whole(1, 3); k > 0; --k) {
    const Point middle = chance.point(0, 1);
    const double radius = chance.between(0.2, 2);
    const int corners = chance.whole(3, 8);
    std::vector<Contour> contours{star(middle, radius, corners, 1, chance.between(0, 6.28))};
    const Contour rim = contours.front();
    for (int c = chance.whole(1, 3); c > 0; --c) {
      Contour hole = star(middle, radius * chance.between(0.1, 0.9), chance.whole(3, 6), 1, chance.between(0, 6.28));
      if (chance.one_in(3)) hole.front() = rim.front();
      if (chance.one_in(3)) hole = {rim[0], rim[1], middle};
      if (chance.one_in(2)) std::reverse(hole.begin(), hole.end());
      contours.push_back(std::move(hole));
    }
    sketch.add(std::move(contours));
  }
  sketch.add_ground();
}

void edges_outside(Sketch& sketch) {
  Chance& chance = sketch.chance;
  for (int k = chance.whole(1, 5); k > 0; --k) {
    const double far = -std::exp(chance.between(0, 7));
    switch (chance.whole(1, 4)) {
      case 1:
        sketch.add(
            {{{far, chance.between(-2, 1)}, {chance.between(0, 1), chance.unit()}, {far, chance.between(0, 3)}}});
        break;
      case 2:
        sketch.add(
            {{{chance.between(-2, 1), far}, {chance.unit(), chance.between(0, 1)}, {chance.between(0, 3), far}}});
        break;
      case 3:
        sketch.add({box(far, far, chance.between(-0.5, 1.5), chance.between(-0.5, 1.5))});
        break;
      default:
        sketch.add({sketch.any_contour(chance.whole(3, 6), far, 2)});
    }
  }
  sketch.add_ground();
}

void level_and_upright_edges(Sketch& sketch) {
  Chance& chance = sketch.chance;
  std::array<double, 6> places{0, 1, chance.unit(), chance.unit(), -0.5, 1.5};
  places[3] = places[2] + chance.tiny(1e-14, 0.1);
  const auto any = [&] { return places[static_cast<std::size_t>(chance.whole(0, 5))]; };
  for (int k = chance.whole(1, 6); k > 0; --k) {
    Contour contour{{any(), any()}};
    for (int i = chance.whole(1, 4); i > 0; --i) {
      const Point p = contour.back();
      const Point q{any(), any()};
      contour.push_back({q.x, p.y});
      contour.push_back(q);
    }
    sketch.add({std::move(contour)});
  }
  if (chance.one_in(2)) sketch.add({sketch.any_contour(3)});
  sketch.add_ground();
}

void large_coordinates(Sketch& sketch) {
  Chance& chance = sketch.chance;
  constexpr double far = 1e6;
  for (int k = chance.whole(1, 6); k > 0; --k) {
    const Point p = chance.point(0, 1);
    const double angle = chance.between(0, 6.28);
    const Point along{far * std::cos(angle), far * std::sin(angle)};
    Contour contour{{p.x - along.x, p.y - along.y}, {p.x + along.x, p.y + along.y}};
    if (chance.one_in(2)) {
      contour.push_back({p.x - along.y, p.y + along.x});
    } else {
      contour.push_back(chance.point(-far, far));
      contour.push_back(chance.point(-0.5, 1.5));
    }
    sketch.add({std::move(contour)});
  }
  sketch.add_ground();
}

}  // namespace moire::test::hard
