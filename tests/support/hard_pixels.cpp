#include "support/hard_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

namespace moire::test {

namespace {

using Contour = std::vector<Point>;

// The standard library's engine is the same everywhere, its distributions are not.
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : engine_(seed) {}

  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double between(double a, double b) { return a + unit() * (b - a); }
  int whole(int first, int last) { return first + static_cast<int>(unit() * (last - first + 1)); }
  bool one_in(int n) { return whole(1, n) == 1; }
  // Of magnitudes as of signs, each is as likely as any other.
  double tiny(double smallest, double largest) {
    return (one_in(2) ? 1 : -1) * std::exp(between(std::log(smallest), std::log(largest)));
  }
  Point point(double low, double high) { return {between(low, high), between(low, high)}; }

 private:
  std::mt19937_64 engine_;
};

// A drawing in the making, about the pixel [0, 1) x [0, 1).
struct Sketch {
  Chance chance;
  std::vector<FlatPolygon> polygons;

  void add(std::vector<Contour> contours, FillRule rule) { polygons.push_back({0, {}, rule, std::move(contours)}); }
  void add(std::vector<Contour> contours) {
    const FillRule rule = any_rule();
    add(std::move(contours), rule);
  }
  FillRule any_rule() { return chance.one_in(2) ? FillRule::nonzero : FillRule::even_odd; }
  Contour any_contour(int corners, double low = -0.5, double high = 1.5) {
    Contour contour;
    for (int i = 0; i < corners; ++i) contour.push_back(chance.point(low, high));
    return contour;
  }
  // One behind the others that leaves nothing of the pixel, or nothing at all.
  void add_ground() {
    if (chance.one_in(2)) add({{{-1, -1}, {2, -1.5}, {2.5, 2}, {-1.25, 2.25}}});
  }
};

Point at(Point p, Point q, double t) { return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)}; }

// Regular, about a middle, from an angle in radians; every `step`th corner comes next.
Contour star(Point middle, double radius, int corners, int step, double angle) {
  Contour contour;
  for (int i = 0; i < corners; ++i) {
    const double a = angle + 2 * std::numbers::pi * step * i / corners;
    contour.push_back({middle.x + radius * std::cos(a), middle.y + radius * std::sin(a)});
  }
  return contour;
}

Contour box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

// ---- One function a kind -------------------------------------------------------------------------------------------

// Triangles about a point, each sharing edges with its neighbours: nothing may be seen between them.
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

// Polygons on both sides of one line that use different stretches of it.
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

// Polygons again and again, each corner moved by 1e-14 .. 1e-6 or not at all.
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

// Corners at the pixel's, on its border, at its middle, and just beside them.
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

// Long and thin, or small all round.
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

// The same polygon many times, begun at other corners and gone round the other way; sometimes something between.
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

// Contours that wind around the same places twice, or once this way and once that way.
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

// Holes that lie inside, touch the rim in a corner, or have an edge of it.
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

// Polygons that begin far on the left of the image or above it, some without a corner inside.
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

// Level and upright ones, on few places so that many lie on each other.
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

// Edges of 1e6 pixels, most of them through the pixel.
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

void thousand_layers(Sketch& sketch) {
  constexpr std::array makes{thousand_strips, thousand_nested, thousand_scattered, thousand_in_a_fan,
                             thousand_duplicates};
  makes[static_cast<std::size_t>(sketch.chance.whole(0, static_cast<int>(makes.size()) - 1))](sketch);
  sketch.add_ground();
}

using Make = void (*)(Sketch&);

constexpr std::array<std::pair<std::string_view, Make>, 12> simple_kinds{{
    {"shared edges", shared_edges},
    {"coincident edges", coincident_edges},
    {"nearly coincident edges", nearly_coincident_edges},
    {"corners on borders", corners_on_borders},
    {"slivers", slivers},
    {"stacked duplicates", stacked_duplicates},
    {"self-intersections", self_intersections},
    {"fill rules", fill_rules},
    {"holes", holes},
    {"edges left of and above the frame", edges_outside},
    {"level and upright edges", level_and_upright_edges},
    {"coordinates of 1e6", large_coordinates},
}};

// Two or three of the others, in any order.
void mixture(Sketch& sketch) {
  for (int k = sketch.chance.whole(2, 3); k > 0; --k) {
    const int last = static_cast<int>(simple_kinds.size()) - 1;
    simple_kinds[static_cast<std::size_t>(sketch.chance.whole(0, last))].second(sketch);
  }
  auto& polygons = sketch.polygons;
  for (std::size_t k = polygons.size(); k > 1; --k) {
    std::swap(polygons[k - 1], polygons[static_cast<std::size_t>(sketch.chance.whole(0, static_cast<int>(k) - 1))]);
  }
}

constexpr auto kinds = [] {
  std::array<std::pair<std::string_view, Make>, simple_kinds.size() + 2> all{};
  std::copy(simple_kinds.begin(), simple_kinds.end(), all.begin());
  all[simple_kinds.size()] = {"mixture", mixture};
  all[simple_kinds.size() + 1] = {"a thousand layers", thousand_layers};
  return all;
}();

constexpr auto names = [] {
  std::array<std::string_view, kinds.size()> all;
  for (std::size_t k = 0; k < kinds.size(); ++k) all[k] = kinds[k].first;
  return all;
}();

// The pixel's place: anywhere in a small image, or where coordinates have lost ten bits.
void place(HardPixel& pixel, Chance& chance) {
  constexpr int far = 1000;
  pixel.size = {3, 3};
  if (chance.one_in(16)) (chance.one_in(2) ? pixel.size.width : pixel.size.height) += far;
  pixel.x = pixel.size.width - chance.whole(1, 3);
  pixel.y = pixel.size.height - chance.whole(1, 3);
  for (FlatPolygon& polygon : pixel.polygons) {
    for (Contour& contour : polygon.contours) {
      for (Point& p : contour) p = {p.x + pixel.x, p.y + pixel.y};
    }
  }
}

}  // namespace

double HardPixel::largest_coordinate() const {
  double largest = 1;
  for (const FlatPolygon& polygon : polygons) {
    for (const Contour& contour : polygon.contours) {
      for (const Point& p : contour) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    }
  }
  return largest;
}

std::span<const std::string_view> hard_pixel_kinds() { return names; }

HardPixel hard_pixel(std::string_view kind, std::uint64_t seed) {
  const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const auto& entry) { return entry.first == kind; });
  Sketch sketch{Chance(seed), {}};
  found->second(sketch);
  HardPixel pixel{found->first, {}, 0, 0, std::move(sketch.polygons)};
  place(pixel, sketch.chance);
  for (std::size_t k = 0; k < pixel.polygons.size(); ++k) {
    FlatPolygon& polygon = pixel.polygons[k];
    polygon.element = k + 1;
    polygon.color = {static_cast<float>(sketch.chance.unit()), static_cast<float>(sketch.chance.unit()),
                     static_cast<float>(sketch.chance.unit())};
  }
  return pixel;
}

}  // namespace moire::test
