// Supersampling: a pixel is the mean of what single rays see at known places.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <map>

#include "plugins/heightfield/brute_force.h"
#include "plugins/heightfield/views.h"

namespace moire::test {
namespace {

// The points of a pixel: `across` x `down` equal cells, and how far down in its cell each lies.
struct Pattern {
  int across, down;
  double place = 0.5;
};

// The weight of each element of a pixel.
std::map<Element, double> expected_weights(const Map& map, const View& view, int x, int y, const Pattern& pattern) {
  const auto [across, down, place] = pattern;
  std::map<Element, double> weights;
  for (int i = 0; i < across; ++i) {
    for (int j = 0; j < down; ++j) {
      const Ray ray = ray_through(view, x + (i + 0.5) / across, y + (j + place) / down);
      weights[seen_by(map, view, ray).front()] += 1.0 / (across * down);
    }
  }
  return weights;
}

Color mean_color(const std::map<Element, double>& weights, const Map& map) {
  double r = 0, g = 0, b = 0;
  for (const auto& [element, weight] : weights) {
    const TexelIndex at = texel_index(element);
    const Color color = element == background ? parse_color("#b8d4f0") : map.color(at.i, at.j);
    r += weight * color.r;
    g += weight * color.g;
    b += weight * color.b;
  }
  return {static_cast<float>(r), static_cast<float>(g), static_cast<float>(b)};
}

bool near(double a, double b) { return std::abs(a - b) <= 1e-6; }

void check_pixels(const char* name, const Changes& changes, const Pattern& pattern) {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  for (const double pitch : {-60.0, -25.0, 0.0}) {
    const View view{
        .caption = "", .x = -37.3, .y = 10007.61, .z = 9.3, .yaw = 3 * pitch + 47, .pitch = pitch, .size = {17, 13}};
    const auto frame = terrain.frame(view, {{"coherence", std::string("none")}});
    const Rendered image = rendered(*sampler(name, changes), *frame);
    for (int y = 0; y < view.size.height; ++y) {
      for (int x = 0; x < view.size.width; ++x) {
        CAPTURE(pitch, x, y);
        const std::map<Element, double> expected = expected_weights(map, view, x, y, pattern);
        std::map<Element, double> found;
        for (const Fragment& fragment : image.at(x, y).fragments) found[fragment.element] += fragment.weight;
        REQUIRE(std::equal(
            found.begin(), found.end(), expected.begin(), expected.end(),
            [](const auto& a, const auto& b) { return a.first == b.first && std::abs(a.second - b.second) <= 1e-12; }));
        const Color mean = mean_color(expected, map), color = image.at(x, y).color;
        REQUIRE((near(color.r, mean.r) && near(color.g, mean.g) && near(color.b, mean.b)));
      }
    }
  }
}

}  // namespace

TEST_CASE("a supersampled grid shows the mean of what a brute force sees at its points") {
  check_pixels("supersample", {{"n", std::int64_t{3}}, {"layout", std::string("grid")}}, {3, 3});
}

TEST_CASE("a supersampled column shows the mean of what a brute force sees at its points") {
  check_pixels("supersample", {{"n", std::int64_t{5}}}, {1, 5});
}

TEST_CASE("points on lower edges see what a brute force sees there") {
  const std::pair<std::string, Value> on_edges{"rays", std::string("lower_edge")};
  check_pixels("point", {on_edges}, {1, 1, 1});
  check_pixels("supersample", {{"n", std::int64_t{5}}, on_edges}, {1, 5, 1});
  check_pixels("supersample", {{"n", std::int64_t{3}}, {"layout", std::string("grid")}, on_edges}, {3, 3, 1});
}

TEST_CASE("one point of supersampling is point sampling") {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  for (const View& view : views_all_round()) {
    CAPTURE(view.caption);
    const auto frame = terrain.frame(view);
    const Rendered one = rendered(*sampler("supersample", {{"n", std::int64_t{1}}}), *frame);
    CHECK(first_difference(rendered(*sampler("point"), *frame), one) == "");
  }
}

}  // namespace moire::test
