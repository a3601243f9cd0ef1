// Footprints in plan against a map made place by place from the definitions.
#include "pictures/footprint_plan.h"

#include <algorithm>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <tuple>

#include <moire/random.h>

#include "message_of.h"

namespace moire::test {

namespace {

using Elements = std::vector<Element>;

Elements sorted(Elements elements) {
  std::sort(elements.begin(), elements.end());
  return elements;
}

bool is_in(const Elements& elements, Element element) {
  return std::find(elements.begin(), elements.end(), element) != elements.end();
}

bool covers(Element element, std::int64_t i, std::int64_t j) {
  const auto [level, a, b] = texel_index(element);
  return i >> level == a && j >> level == b;  // shifts of negative numbers round down
}

struct Point2 {
  std::int64_t i, j;  // in halves of a texel
};

std::vector<Point2> corners_of(const Elements& elements) {
  std::vector<Point2> result;
  for (Element element : elements) {
    const auto [level, i, j] = texel_index(element);
    for (int a : {0, 1}) {
      for (int b : {0, 1}) result.push_back({(i + a) * 2 << level, (j + b) * 2 << level});
    }
  }
  return result;
}

std::int64_t turn(Point2 a, Point2 b, Point2 c) { return (b.i - a.i) * (c.j - a.j) - (b.j - a.j) * (c.i - a.i); }

// The lines through two corners that have all corners on their left: the sides of the convex hull.
std::vector<std::pair<Point2, Point2>> sides_of_hull(const Elements& elements) {
  const std::vector<Point2> corners = corners_of(elements);
  std::vector<std::pair<Point2, Point2>> sides;
  for (const Point2& a : corners) {
    for (const Point2& b : corners) {
      if (a.i == b.i && a.j == b.j) continue;
      if (std::all_of(corners.begin(), corners.end(), [&](const Point2& c) { return turn(a, b, c) >= 0; }))
        sides.push_back({a, b});
    }
  }
  return sides;
}

// The map texel by texel, and what is counted.
struct Map {
  std::int64_t i0, j0, i1, j1;
  std::vector<Color> places;
  std::size_t hidden = 0;
};

Map brute_force(const Elements& visible, const Elements& seen) {
  Map map{1000, 1000, -1000, -1000, {}};
  for (const Elements* elements : {&visible, &seen}) {
    for (const Point2& c : corners_of(*elements)) {
      map.i0 = std::min(map.i0, c.i / 2), map.i1 = std::max(map.i1, c.i / 2);
      map.j0 = std::min(map.j0, c.j / 2), map.j1 = std::max(map.j1, c.j / 2);
    }
  }
  const auto sides = sides_of_hull(visible);
  for (std::int64_t j = map.j0; j < map.j1; ++j) {
    for (std::int64_t i = map.i0; i < map.i1; ++i) {
      // Levels rise with elements, so the first that covers is the finest.
      const auto over = [&](Element element) { return covers(element, i, j); };
      const auto v = std::find_if(visible.begin(), visible.end(), over);
      const Point2 middle{2 * i + 1, 2 * j + 1};
      Color place = footprint_colors::outside;
      if (v != visible.end()) {
        place = is_in(seen, *v) ? footprint_colors::sampled : footprint_colors::missed;
      } else if (std::any_of(seen.begin(), seen.end(), over)) {
        place = footprint_colors::leaked;
      } else if (!sides.empty() && std::all_of(sides.begin(), sides.end(), [&](const auto& side) {
                   return turn(side.first, side.second, middle) > 0;
                 })) {
        place = footprint_colors::hidden;
        ++map.hidden;
      }
      map.places.push_back(place);
    }
  }
  return map;
}

// The picture shows the map with each texel as a square of whole pixels, as large as fits into 480.
void check_picture(const Picture& picture, const Map& map) {
  const auto columns = static_cast<int>(map.i1 - map.i0), rows = static_cast<int>(map.j1 - map.j0);
  const int pixels = 480 / std::max(columns, rows);
  REQUIRE(picture.size == ImageSize{columns * pixels, rows * pixels});
  int wrong = 0;
  for (int y = 0; y < picture.size.height; ++y) {
    for (int x = 0; x < picture.size.width; ++x) {
      wrong += picture.pixels[static_cast<std::size_t>(y * picture.size.width + x)] !=
               map.places[static_cast<std::size_t>(y / pixels * columns + x / pixels)];
    }
  }
  CHECK(wrong == 0);
}

void check(const Elements& visible, const Elements& seen) {
  const FootprintPlan plan = footprint_plan(visible, seen);
  const Map map = brute_force(visible, seen);
  const auto sampled =
      std::count_if(visible.begin(), visible.end(), [&](Element element) { return is_in(seen, element); });
  CHECK(plan.sampled == static_cast<std::size_t>(sampled));
  CHECK(plan.missed == visible.size() - plan.sampled);
  CHECK(plan.leaked == seen.size() - plan.sampled);
  CHECK(plan.hidden == map.hidden);
  check_picture(plan.picture, map);
}

// Elements of levels 0 .. levels - 1 in [-8, 8) x [-8, 8), each there with this probability.
std::pair<Elements, Elements> random_sets(int levels, double visible_share, double seen_share, std::uint64_t seed) {
  Elements visible, seen;
  std::uint32_t k = 0;
  for (int level = 0; level < levels; ++level) {
    for (std::int64_t i = -8 >> level; i < 8 >> level; ++i) {
      for (std::int64_t j = -8 >> level; j < 8 >> level; ++j, ++k) {
        const Element element = texel_element(level, i, j);
        if (random({.seed = seed}, k, 0) < visible_share) visible.push_back(element);
        if (random({.seed = seed}, k, 1) < seen_share) seen.push_back(element);
      }
    }
  }
  return {sorted(visible), sorted(seen)};
}

}  // namespace

TEST_CASE("a footprint in plan is the map that the definitions give, place by place") {
  bool has_hidden = false, has_none = false;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const double share = seed % 2 == 0 ? 0.03 : 0.006;  // about 8 texels of each, or 2
    const auto [visible, seen] = random_sets(1, share, share, seed);
    if (visible.empty() && seen.empty()) continue;
    CAPTURE(seed);
    check(visible, seen);
    const std::size_t hidden = footprint_plan(visible, seen).hidden;
    has_hidden = has_hidden || hidden > 0;
    has_none = has_none || hidden == 0;
  }
  CHECK(has_hidden);
  CHECK(has_none);
}

TEST_CASE("in a footprint of several levels visible texels lie over leaked ones, and finer over coarser") {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const auto [visible, seen] = random_sets(3, 0.05, 0.05, seed);
    if (visible.empty() && seen.empty()) continue;
    CAPTURE(seed);
    check(visible, seen);
  }
  // A missed texel within a coarser one that is sampled.
  const Element fine = texel_element(0, 1, 0), coarse = texel_element(1, 0, 0);
  const FootprintPlan plan = footprint_plan(sorted({fine, coarse}), {coarse});
  CHECK(plan.sampled == 1);
  CHECK(plan.missed == 1);
  CHECK(plan.picture.pixels.front() == footprint_colors::sampled);
  CHECK(plan.picture.pixels[479] == footprint_colors::missed);
}

TEST_CASE("places whose middle lies on the edge of the hull are outside") {
  // The hull's slanting sides are diagonals of texels.
  const Elements visible = sorted({texel_element(0, 0, 0), texel_element(0, 5, 5)});
  check(visible, {});
  CHECK(footprint_plan(visible, {}).hidden == 4);  // of the diagonal; its neighbours' middles lie on the edge
  // And sides of all slopes through middles: (0, 1) and (2i + 1, 2j + 2) have (i + .5, j + 1.5) between them.
  for (std::int64_t i = 0; i < 7; ++i) {
    for (std::int64_t j = 0; j < 7; ++j) {
      CAPTURE(i, j);
      check(sorted({texel_element(0, 0, 0), texel_element(0, 2 * i + 1, 2 * j + 1)}), {});
    }
  }
}

TEST_CASE("what leaks beyond the hull hides nothing, on whichever side it lies") {
  const Elements visible = sorted({texel_element(0, 0, 0), texel_element(0, 2, 1), texel_element(0, 1, 4)});
  for (const auto& [i, j] : {std::pair(-5, 1), std::pair(7, 1), std::pair(1, -5), std::pair(1, 9)}) {
    CAPTURE(i, j);
    const Elements leaked{texel_element(0, i, j)};
    check(visible, leaked);
    CHECK(footprint_plan(visible, leaked).hidden == footprint_plan(visible, {}).hidden);
  }
}

TEST_CASE("texels in a row, in a column and alone hide nothing but what lies between them") {
  CHECK(footprint_plan({texel_element(0, 3, 4)}, {}).hidden == 0);
  CHECK(footprint_plan(sorted({texel_element(0, -2, 4), texel_element(0, 3, 4)}), {}).hidden == 4);
  CHECK(footprint_plan(sorted({texel_element(0, 3, -4), texel_element(0, 3, 4)}), {}).hidden == 7);
  check(sorted({texel_element(0, -2, 4), texel_element(0, 3, 4)}), {});
  check(sorted({texel_element(0, 3, -4), texel_element(0, 3, 4)}), {});
}

TEST_CASE("a footprint without visible texels shows what is sampled, one without any an empty picture") {
  const FootprintPlan leak = footprint_plan({}, {texel_element(0, 3, 4)});
  CHECK(leak.leaked == 1);
  CHECK(leak.hidden == 0);
  CHECK(leak.picture.size == ImageSize{480, 480});
  CHECK(leak.picture.pixels == std::vector<Color>(480 * 480, footprint_colors::leaked));

  const FootprintPlan nothing = footprint_plan({}, {});
  CHECK(nothing.picture.size == ImageSize{1, 1});
  CHECK(nothing.picture.pixels == std::vector<Color>{footprint_colors::outside});
  CHECK(nothing.sampled + nothing.missed + nothing.leaked + nothing.hidden == 0);
}

TEST_CASE("a footprint too wide to be shown texel by texel is shown by means of whole texels") {
  // 961 x 1 texels: 3 x 3 a pixel, of which the map fills one row. The ends are visible, the first of them sampled.
  const Element first = texel_element(0, 100, 7), last = texel_element(0, 1060, 7);
  const Picture picture = footprint_plan({first, last}, {first}).picture;
  REQUIRE(picture.size == ImageSize{321, 1});
  using namespace footprint_colors;
  const auto check_mean = [](Color found, std::vector<Color> of) {
    of.resize(9, outside);
    Color sum;
    for (Color c : of) sum = sum + c;
    const auto near = [](float value) { return Catch::Approx(value).epsilon(1e-6); };  // nine roundings of floats
    CHECK(found.r == near(sum.r / 9));
    CHECK(found.g == near(sum.g / 9));
    CHECK(found.b == near(sum.b / 9));
  };
  check_mean(picture.pixels[0], {sampled, hidden, hidden});
  check_mean(picture.pixels[200], {hidden, hidden, hidden});
  check_mean(picture.pixels[319], {hidden, hidden, hidden});
  check_mean(picture.pixels[320], {missed});
}

TEST_CASE("pixels of a footprint's picture are whole numbers of texels or texels whole numbers of pixels") {
  const auto side = [](std::int64_t texels) {
    return footprint_plan(sorted({texel_element(0, 0, 0), texel_element(0, texels - 1, 0)}), {}).picture.size.width;
  };
  CHECK(side(2) == 480);
  CHECK(side(7) == 476);
  CHECK(side(240) == 480);
  CHECK(side(241) == 241);
  CHECK(side(480) == 480);
  CHECK(side(481) == 241);
  CHECK(side(8192) == 456);
}

TEST_CASE("a footprint that spans too much is refused, whichever set does it") {
  const Element near = texel_element(0, 0, 0), far = texel_element(0, 8192, 0), deep = texel_element(0, 0, -8192);
  CHECK(message_of([&] {
          footprint_plan({near, far}, {});
        }) == "footprint: spans 8193 x 1 texels, at most 8192 are shown; choose a smaller window");
  CHECK(message_of([&] { footprint_plan({near}, {deep}); }) ==
        "footprint: spans 1 x 8193 texels, at most 8192 are shown; choose a smaller window");
}

}  // namespace moire::test
