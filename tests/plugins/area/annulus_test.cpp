// Rings and disks, against visible lengths integrated in extended precision and against what is known on paper.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <map>
#include <numbers>

#include <fmt/format.h>

#include "exact/curves/annulus.h"
#include "sanitized.h"
#include "support/curve_oracle.h"
#include "support/hard_pixels/sketch.h"

namespace moire::test {
namespace {

using Image = std::map<std::pair<int, int>, double>;

Image image(const CircleCurve& circle, const PixelArea& clip) {
  Image image;
  area::Annulus(circle).areas(clip, [&](int x, int y, double area) {
    CHECK((area >= 0 && area <= 1));
    if (area > 0) CHECK(image.emplace(std::pair(x, y), area).second);
    CHECK((x >= clip.x0 && y >= clip.y0 && x < clip.x0 + clip.width && y < clip.y0 + clip.height));
  });
  return image;
}

double error(const CircleCurve& circle, const PixelArea& window) {
  const Image found = image(circle, window);
  const Curve curve = circle;
  double largest = 0;
  for (int y = window.y0; y < window.y0 + window.height; ++y) {
    for (int x = window.x0; x < window.x0 + window.width; ++x) {
      const auto pixel = found.find({x, y});
      const double area = pixel == found.end() ? 0 : pixel->second;
      largest = std::max(largest, std::abs(area - visible_areas({&curve, 1}, x, y)[0]));
    }
  }
  return largest;
}

// What is rounded has the size of a pixel, not that of the radius.
constexpr double bound = 1e-14;

}  // namespace

TEST_CASE("small rings and disks with real centres have their exact areas in each pixel") {
  hard::Chance random(1);
  for (int k = 0; k < (sanitized ? 30 : 150); ++k) {
    CircleCurve circle{1, {}, {random.between(3, 5), random.between(3, 5)}, random.between(0, 3), random.between(0, 2)};
    if (k % 5 == 0) circle.center = {4, 4};
    if (k % 7 == 0) circle.radius = std::floor(circle.radius) + .5, circle.width = 1;
    if (k % 11 == 0) circle.radius = random.between(0, .4), circle.width = .1;  // within a pixel
    if (k % 13 == 0) circle.center.x = 4.5;
    INFO(fmt::format("{} {}, radius {}, width {}", circle.center.x, circle.center.y, circle.radius, circle.width));
    CHECK(error(circle, {0, 0, 9, 9}) <= bound);
  }
}

TEST_CASE("circles of every radius to 65,535 have exact areas all around") {
  hard::Chance random(2);
  for (const double radius : {20.0, 100.0, 100.3, 1000.25, 16383.7, 65535.0, 65535.3}) {
    for (int k = 0; k < (sanitized ? 10 : 24); ++k) {
      const CircleCurve circle{
          1, {}, {random.between(500, 520), random.between(500, 520)}, radius, k % 3 == 0 ? 2.5 : 1};
      // At the axes, on the diagonals and elsewhere.
      const double angle = k < 8 ? k * std::numbers::pi / 4 : random.between(0, 6.3);
      const int x = static_cast<int>(std::floor(circle.center.x + radius * std::cos(angle)));
      const int y = static_cast<int>(std::floor(circle.center.y + radius * std::sin(angle)));
      INFO(fmt::format("{} {}, radius {}, width {}, pixel {} {}", circle.center.x, circle.center.y, circle.radius,
                       circle.width, x, y));
      CHECK(error(circle, {x - 2, y - 2, 5, 5}) <= bound);
      CHECK(!image(circle, {x - 2, y - 2, 5, 5}).empty());
    }
  }
}

TEST_CASE("the areas of all pixels of a ring sum to the ring's") {
  for (const double radius : {0.3, 2.0, 50.7, 300.0}) {
    for (const double width : {0.01, 1.0, 5.0}) {
      const int reach = static_cast<int>(radius + width) + 2;
      double sum = 0;
      const Image all = image({1, {}, {.3, .7}, radius, width}, {-reach, -reach, 2 * reach, 2 * reach});
      for (const auto& [pixel, area] : all) sum += area;
      const double outer = radius + width / 2, inner = std::max(radius - width / 2, 0.0);
      CHECK(std::abs(sum - std::numbers::pi * (outer - inner) * (outer + inner)) <=
            bound * static_cast<double>(all.size()));
    }
  }
}

TEST_CASE("a ring's pixels are the same to the bit whatever they are clipped to") {
  hard::Chance random(3);
  for (int k = 0; k < 100; ++k) {
    const CircleCurve circle{
        1, {}, {random.between(0, 40), random.between(0, 40)}, random.between(0, 30), random.between(0, 5)};
    const Image whole = image(circle, {0, 0, 40, 40});
    Image parts;
    for (int y = 0; y < 40; y += 8) {
      for (int x = 0; x < 40; x += 5) parts.merge(image(circle, {x, y, 5, 8}));
    }
    CHECK(whole == parts);
  }
}

TEST_CASE("circles without width have no area, those without radius are disks, enormous ones are finite") {
  const PixelArea clip{0, 0, 8, 8};
  CHECK(image({1, {}, {4, 4}, 2, 0}, clip).empty());
  CHECK(image({1, {}, {4, 4}, 0, 0}, clip).empty());
  const Image dot = image({1, {}, {4.5, 4.5}, 0, 1}, clip);
  CHECK(dot.size() == 1);
  CHECK(std::abs(dot.at({4, 4}) - std::numbers::pi / 4) <= bound);
  for (const double far : {1e9, 1e15, 1e100, 1e300}) {
    CHECK(image({1, {}, {far, far}, 1, 1}, clip).empty());
    CHECK(image({1, {}, {4, 4}, far, 1}, clip).empty());
    CHECK(image({1, {}, {4, 4}, 0, far}, clip).size() == 64);
    for (const auto& [pixel, area] : image({1, {}, {-far, 4}, far, 4}, clip)) CHECK(area <= 1);
  }
}

}  // namespace moire::test
