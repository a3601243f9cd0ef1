#include "support/hard_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "support/hard_pixels/simple_kinds.h"
#include "support/hard_pixels/thousand_layers.h"

namespace moire::test {

namespace {

using namespace hard;

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
