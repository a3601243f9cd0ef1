// A pyramid's texels against the averages that they stand for, summed in another way and with more digits.
#include <moire/pyramid.h>

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <limits>
#include <utility>

#include <moire/random.h>

namespace moire::test {
namespace {

constexpr std::pair<int, int> sizes[] = {{1, 1}, {2, 2}, {16, 8}, {1, 7}, {13, 1}, {5, 3}, {100, 37}, {255, 63}};

std::vector<float> noise(int width, int height) {
  std::vector<float> rgb;
  for (int k = 0; k < 3 * width * height; ++k) rgb.push_back(static_cast<float>(random({.x = k}, 0, 0)));
  return rgb;
}

const float* texel(const Pyramid::Level& level, int i, int j) { return level.rgba.data() + 4 * (j * level.width + i); }

// The part of [k, k + 1) that lies in [begin, end).
long double part(int k, long double begin, long double end) {
  return std::max(0.0L, std::min<long double>(k + 1, end) - std::max<long double>(k, begin));
}

// The average of a channel over a rectangle of level 0, texel by texel.
long double average(const std::vector<float>& rgb, int width, int height, int channel, long double s0, long double s1,
                    long double t0, long double t1) {
  long double sum = 0;
  for (int j = static_cast<int>(t0); j < std::min<long double>(height, t1); ++j) {
    for (int i = static_cast<int>(s0); i < std::min<long double>(width, s1); ++i) {
      sum += part(i, s0, s1) * part(j, t0, t1) * rgb[static_cast<std::size_t>(3 * (j * width + i) + channel)];
    }
  }
  return sum / ((s1 - s0) * (t1 - t0));
}

}  // namespace

TEST_CASE("a pyramid's levels halve both sides, rounded down, to a single texel") {
  for (const auto& [width, height] : sizes) {
    CAPTURE(width, height);
    const std::vector<float> rgb = noise(width, height);
    const Pyramid pyramid(rgb.data(), 3, width, height);
    for (int l = 0; l < pyramid.levels(); ++l) {
      const Pyramid::Level& level = pyramid.level(l);
      CHECK(level.width == std::max(1, width >> l));
      CHECK(level.height == std::max(1, height >> l));
      CHECK(level.s_scale == static_cast<double>(level.width) / width);
      CHECK(level.t_scale == static_cast<double>(level.height) / height);
      CHECK((level.width * level.height == 1) == (l == pyramid.levels() - 1));
    }
  }
}

// Values below 1: rounding to a float moves them by 2^-25 at most. All else must be right to 1e-12.
TEST_CASE("a pyramid's texel is the average of the part of the texture that it covers, whatever the sizes") {
  for (const auto& [width, height] : sizes) {
    const std::vector<float> rgb = noise(width, height);
    const Pyramid pyramid(rgb.data(), 3, width, height);
    double farthest = 0, farthest_mean = 0;
    for (int l = 0; l < pyramid.levels(); ++l) {
      const Pyramid::Level& level = pyramid.level(l);
      const long double across = static_cast<long double>(width) / level.width;
      const long double down = static_cast<long double>(height) / level.height;
      for (int c = 0; c < 3; ++c) {
        long double mean = 0;
        for (int j = 0; j < level.height; ++j) {
          for (int i = 0; i < level.width; ++i) {
            const long double exact =
                average(rgb, width, height, c, i * across, (i + 1) * across, j * down, (j + 1) * down);
            farthest = std::max(farthest, static_cast<double>(std::abs(texel(level, i, j)[c] - exact)));
            mean += texel(level, i, j)[c];
          }
        }
        const long double exact_mean = average(rgb, width, height, c, 0, width, 0, height);
        mean /= level.width * level.height;
        farthest_mean = std::max(farthest_mean, static_cast<double>(std::abs(mean - exact_mean)));
      }
    }
    CAPTURE(width, height);
    CHECK(farthest <= 0x1p-25 + 1e-12);
    CHECK(farthest_mean <= 0x1p-25 + 1e-12);
  }
}

// Multiples of 1 / 256 and sides that are powers of two: all averages are floats, so that no rounding hides an error.
TEST_CASE("averages that floats can hold are kept to the last bit, and with them the mean") {
  constexpr int side = 64;
  std::vector<float> rgb = noise(side, side);
  for (float& value : rgb) value = std::floor(value * 256) / 256;
  const Pyramid pyramid(rgb.data(), 3, side, side);
  for (int l = 0; l < pyramid.levels(); ++l) {
    const Pyramid::Level& level = pyramid.level(l);
    double mean = 0;
    for (int j = 0; j < level.height; ++j) {
      for (int i = 0; i < level.width; ++i) {
        const int covered = side / level.width;
        REQUIRE(texel(level, i, j)[1] ==
                average(rgb, side, side, 1, i * covered, (i + 1) * covered, j * covered, (j + 1) * covered));
        mean += static_cast<double>(texel(level, i, j)[1]);
      }
    }
    CHECK(mean / (level.width * level.height) == average(rgb, side, side, 1, 0, side, 0, side));
  }
}

TEST_CASE("a texture of one colour has that colour on all levels, bit for bit") {
  for (const auto& [width, height] : {std::pair{1023, 511}, {1, 100}, {64, 64}}) {
    const float colors[] = {0.1F, 1.0F / 3, 12345.678F};
    std::vector<float> rgb;
    for (int k = 0; k < width * height; ++k) rgb.insert(rgb.end(), colors, colors + 3);
    const Pyramid pyramid(rgb.data(), 3, width, height);
    for (int l = 0; l < pyramid.levels(); ++l) {
      const Pyramid::Level& level = pyramid.level(l);
      bool is_same = true;
      for (int k = 0; k < level.width * level.height; ++k) {
        for (int c = 0; c < 3; ++c) is_same = is_same && level.rgba[static_cast<std::size_t>(4 * k + c)] == colors[c];
      }
      CHECK(is_same);
    }
  }
}

TEST_CASE("a texel that is no number makes those above it none, and no others") {
  constexpr int width = 10, height = 6, column = 3, row = 4;
  std::vector<float> rgb = noise(width, height);
  rgb[3 * (row * width + column)] = std::numeric_limits<float>::quiet_NaN();
  const Pyramid pyramid(rgb.data(), 3, width, height);
  for (int l = 0; l < pyramid.levels(); ++l) {
    const Pyramid::Level& level = pyramid.level(l);
    for (int j = 0; j < level.height; ++j) {
      for (int i = 0; i < level.width; ++i) {
        CAPTURE(l, i, j);
        // Overlaps: i w_0 / w_l < column + 1 and column < (i + 1) w_0 / w_l, likewise down.
        const bool covers = i * width < (column + 1) * level.width && column * level.width < (i + 1) * width &&
                            j * height < (row + 1) * level.height && row * level.height < (j + 1) * height;
        CHECK(std::isnan(texel(level, i, j)[0]) == covers);
        CHECK(std::isfinite(texel(level, i, j)[1]));
      }
    }
  }
}

TEST_CASE("a pyramid reads texels that lie between other data") {
  const std::vector<float> rgb = noise(7, 5);
  std::vector<float> cells;
  for (std::size_t k = 0; k < rgb.size(); k += 3) cells.insert(cells.end(), {1e9F, rgb[k], rgb[k + 1], rgb[k + 2]});
  const Pyramid apart(cells.data() + 1, 4, 7, 5), together(rgb.data(), 3, 7, 5);
  for (int l = 0; l < together.levels(); ++l) CHECK(apart.level(l).rgba == together.level(l).rgba);
}

}  // namespace moire::test
