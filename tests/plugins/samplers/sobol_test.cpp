// Sobol's points under a hash that scrambles: held to what nested permutations keep, and to a scramble that draws every
// permutation by itself, level by level.
#include <bit>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <functional>

#include "plugins/samplers/patterns.h"

namespace moire::test {

namespace {

std::vector<Points::Entry> sobol(std::int64_t count, const Pixel& pixel) {
  return points_of(*pattern("sobol", {{"points", count}}), pixel);
}

std::uint32_t digits(double number) { return static_cast<std::uint32_t>(number * 0x1p32); }

// The first 32 binary digits of point `index` in both dimensions, by the matrices: the identity, and Pascal's triangle
// modulo 2, whose entry (row, column) is odd where row is within column bit by bit.
std::uint32_t unscrambled(std::uint32_t index, bool is_second) {
  std::uint32_t result = 0;
  for (std::uint32_t row = 0; row < 32; ++row) {
    std::uint32_t digit = 0;
    for (std::uint32_t column = 0; column < 32; ++column) {
      const bool entry = is_second ? (row & column) == row : row == column;
      if (entry) digit ^= index >> column & 1;
    }
    result |= digit << (31 - row);
  }
  return result;
}

int common_digits(std::uint32_t a, std::uint32_t b) { return std::countl_zero(a ^ b); }

// Owen's scramble as he defines it: whether a digit is turned is a random number of its own for each string of digits
// before it. 24 levels; what is left below is random.
std::uint32_t nested(std::uint32_t x, std::uint64_t key) {
  std::uint32_t result = 0;
  for (int level = 0; level < 24; ++level) {
    const std::uint64_t before = level == 0 ? 0 : x >> (32 - level);
    const std::uint64_t hash = mixed(mixed(key + static_cast<std::uint64_t>(level)) ^ before * 0x9e3779b97f4a7c15U);
    const std::uint32_t digit = x >> (31 - level) & 1;
    result |= (digit ^ static_cast<std::uint32_t>(hash >> 63)) << (31 - level);
  }
  return result | static_cast<std::uint32_t>(mixed(key ^ x)) >> 24;
}

struct Mean {
  double value, standard_error;
};

// Of the squared error of a pixel's mean.
Mean mean_square(const std::vector<double>& errors) {
  double sum = 0, squares = 0;
  for (const double error : errors) {
    sum += error * error;
    squares += std::pow(error, 4);
  }
  const auto count = static_cast<double>(errors.size());
  const double mean = sum / count;
  return {mean, std::sqrt((squares / count - mean * mean) / count)};
}

}  // namespace

TEST_CASE("of 2^k Sobol points every box of area 2^-k whose sides are powers of two has one") {
  for (int k = 0; k <= 12; ++k) {
    const int count = 1 << k;
    for (const Pixel& pixel : {Pixel{0, 0, 0, 0}, Pixel{5, 9, 0, 1}, Pixel{-1, 1000, 0, 77}}) {
      const auto points = sobol(count, pixel);
      REQUIRE(points.size() == static_cast<std::size_t>(count));
      for (int across = 0; across <= k; ++across) {
        CAPTURE(k, across, pixel.x);
        std::vector<int> boxes(static_cast<std::size_t>(count));
        for (const auto& point : points) {
          const auto column = static_cast<std::size_t>(std::ldexp(point.x, across));
          const auto row = static_cast<std::size_t>(std::ldexp(point.y, k - across));
          ++boxes[(column << (k - across)) + row];
        }
        CHECK(std::all_of(boxes.begin(), boxes.end(), [](int points_in_box) { return points_in_box == 1; }));
      }
    }
  }
}

TEST_CASE("scrambled points share as many digits as Sobol's own, which is what nested permutations keep") {
  constexpr std::uint32_t count = 512;
  for (const Pixel& pixel : {Pixel{0, 0, 0, 0}, Pixel{7, 3, 0, 5}}) {
    const auto points = sobol(count, pixel);
    std::size_t wrong = 0;
    for (std::uint32_t a = 0; a < count; ++a) {
      for (std::uint32_t b = 0; b < a; ++b) {
        const int across = common_digits(unscrambled(a, false), unscrambled(b, false));
        const int down = common_digits(unscrambled(a, true), unscrambled(b, true));
        if (common_digits(digits(points[a].x), digits(points[b].x)) != across) ++wrong;
        if (common_digits(digits(points[a].y), digits(points[b].y)) != down) ++wrong;
      }
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("each digit of a scrambled point is turned in half of the pixels, on its own") {
  constexpr int side = 64, levels = 12;
  constexpr double count = side * side;
  const auto made = pattern("sobol", {{"points", std::int64_t{8}}});
  for (const std::size_t sample : {std::size_t{0}, std::size_t{5}}) {
    std::vector<std::vector<double>> turned(2 * levels);  // -1 or 1
    for (int x = 0; x < side; ++x) {
      for (int y = 0; y < side; ++y) {
        const auto point = points_of(*made, {x, y, 0, 1})[sample];
        for (int level = 0; level < levels; ++level) {
          const auto sign = [&](double number) { return (digits(number) >> (31 - level) & 1) != 0 ? 1.0 : -1.0; };
          turned[static_cast<std::size_t>(level)].push_back(sign(point.x));
          turned[static_cast<std::size_t>(levels + level)].push_back(sign(point.y));
        }
      }
    }
    double largest = 0;
    for (std::size_t a = 0; a < turned.size(); ++a) {
      for (std::size_t b = 0; b <= a; ++b) {
        double sum = 0;
        for (std::size_t k = 0; k < turned[a].size(); ++k) sum += a == b ? turned[a][k] : turned[a][k] * turned[b][k];
        largest = std::max(largest, std::abs(sum) / std::sqrt(count));
      }
    }
    // 300 sums of 4096 independent signs, in standard deviations: one is beyond 5 once in 6000 such tests.
    CHECK(largest < 5);
  }
}

TEST_CASE("the hash scrambles as well as permutations drawn one by one: the errors of integrals are of one size") {
  // The mean of a smooth bump and of a slanted edge over the pixel, by points of both scrambles in 4096 pixels.
  const std::vector<std::function<double(double, double)>> functions = {
      [](double x, double y) { return std::exp(-2 * (std::pow(x - 0.3, 2) + std::pow(y - 0.6, 2))); },
      [](double x, double y) { return y < 0.2 + 0.364 * x ? 1.0 : 0.0; }};
  const auto gauss = [](double from, double to) {  // of exp(-2 t^2)
    return std::sqrt(std::acos(-1.0) / 8) * (std::erf(std::sqrt(2.0) * to) - std::erf(std::sqrt(2.0) * from));
  };
  const double exact[] = {gauss(-0.3, 0.7) * gauss(-0.6, 0.4), 0.2 + 0.364 / 2};
  for (const std::uint32_t count : {16U, 64U}) {
    const auto made = pattern("sobol", {{"points", std::int64_t{count}}});
    for (std::size_t f = 0; f < functions.size(); ++f) {
      std::vector<double> hashed, drawn;
      for (int x = 0; x < 64; ++x) {
        for (int y = 0; y < 64; ++y) {
          double one = 0, other = 0;
          for (const auto& point : points_of(*made, {x, y, 0, 3})) one += functions[f](point.x, point.y);
          const std::uint64_t key = mixed(static_cast<std::uint64_t>(x * 64 + y + 1));
          for (std::uint32_t k = 0; k < count; ++k) {
            other += functions[f]((nested(unscrambled(k, false), key) + 0.5) * 0x1p-32,
                                  (nested(unscrambled(k, true), ~key) + 0.5) * 0x1p-32);
          }
          hashed.push_back(one / count - exact[f]);
          drawn.push_back(other / count - exact[f]);
        }
      }
      const Mean a = mean_square(hashed), b = mean_square(drawn);
      CAPTURE(count, f, a.value, b.value);
      CHECK(std::abs(a.value - b.value) < 4 * std::hypot(a.standard_error, b.standard_error));
      // Far below the variance of independent points.
      CHECK(a.value < 0.5 * exact[f] * (1 - exact[f]) / count);
    }
  }
}

}  // namespace moire::test
