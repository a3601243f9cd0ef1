// The built-in landscape: the same bits everywhere, within its bounds, and hard to sample well.
#include "fractal/fractal.h"

#include <algorithm>
#include <bit>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "fractal/ground.h"

namespace heightfield {
namespace {

// FNV-1a over the bits of the numbers.
class Hash {
 public:
  void add(float number) {
    const auto bits = std::bit_cast<std::uint32_t>(number);
    for (int shift = 0; shift < 32; shift += 8) value_ = (value_ ^ ((bits >> shift) & 0xff)) * 0x100000001b3U;
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

std::uint64_t hash_of_heights(const Terrain& terrain) {
  Hash hash;
  for (const float height : terrain.heights) hash.add(height);
  return hash.value();
}

std::uint64_t hash_of_colors(const Terrain& terrain) {
  Hash hash;
  for (const moire::Color& color : terrain.colors)
    for (const float channel : {color.r, color.g, color.b}) hash.add(channel);
  return hash.value();
}

double brightness(const moire::Color& color) { return (color.r + color.g + color.b) / 3; }

// Within squares of 4 x 4 voxels: the root of the mean variance of brightness, as part of the mean brightness.
double local_contrast(const Terrain& terrain) {
  constexpr int side = 4;
  double variance = 0, mean = 0;
  int squares = 0;
  for (int y0 = 0; y0 + side <= terrain.height; y0 += side)
    for (int x0 = 0; x0 + side <= terrain.width; x0 += side, ++squares) {
      double sum = 0, sum_of_squares = 0;
      for (int k = 0; k < side * side; ++k) {
        const int i = (y0 + k / side) * terrain.width + x0 + k % side;
        const double b = brightness(terrain.colors[static_cast<std::size_t>(i)]);
        sum += b;
        sum_of_squares += b * b;
      }
      const double square_mean = sum / (side * side);
      mean += square_mean;
      variance += sum_of_squares / (side * side) - square_mean * square_mean;
    }
  return std::sqrt(variance / squares) / (mean / squares);
}

}  // namespace

TEST_CASE("the fractal terrain has the same bits on every machine") {
  const Terrain terrain = fractal(256, 1, 40);
  CHECK(hash_of_heights(terrain) == 0x4c4f1a96fa40611bU);
  CHECK(hash_of_colors(terrain) == 0x890f8afe3ff08a0cU);
}

TEST_CASE("another seed makes another terrain") {
  const Terrain one = fractal(64, 1, 20), other = fractal(64, 2, 20);
  CHECK(hash_of_heights(one) != hash_of_heights(other));
  CHECK(hash_of_colors(one) != hash_of_colors(other));
}

TEST_CASE("the fractal terrain keeps within its bounds at any size") {
  for (const int size : {1, 2, 7, 64, 300})
    for (const double relief : {0.5, 30.0, 200.0}) {
      CAPTURE(size, relief);
      const Terrain terrain = fractal(size, 3, relief);
      REQUIRE(terrain.width == size);
      REQUIRE(terrain.height == size);
      REQUIRE(terrain.heights.size() == static_cast<std::size_t>(size * size));
      REQUIRE(terrain.colors.size() == terrain.heights.size());
      // Comparisons fail for what is not a number.
      CHECK(std::all_of(terrain.heights.begin(), terrain.heights.end(),
                        [&](float h) { return h >= 0 && h <= relief + tallest_cover; }));
      CHECK(std::all_of(terrain.colors.begin(), terrain.colors.end(), [](const moire::Color& c) {
        return std::min({c.r, c.g, c.b}) >= 0 && std::max({c.r, c.g, c.b}) <= 1;
      }));
    }
}

TEST_CASE("the fractal terrain uses the relief it is given") {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    const Ground ground = raise_ground(256, seed, 40);
    CHECK(*std::max_element(ground.height.values.begin(), ground.height.values.end()) > 0.85 * 40);
  }
}

TEST_CASE("water is level but for the bridges over it") {
  const Ground ground = raise_ground(512, 1, 60);
  const Terrain terrain = fractal(512, 1, 60);
  int water = 0, raised = 0;
  for (std::size_t i = 0; i < terrain.heights.size(); ++i) {
    if (ground.height.values[i] >= 0) continue;
    ++water;
    if (terrain.heights[i] > 0) ++raised;
  }
  CHECK(water > 512 * 512 / 40);
  CHECK(raised < water / 20);
}

TEST_CASE("single voxels of the fractal terrain stand out from their neighbours") {
  for (const std::uint64_t seed : {1U, 2U, 3U}) CHECK(local_contrast(fractal(512, seed, 60)) > 0.3);
}

}  // namespace heightfield
