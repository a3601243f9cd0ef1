// Random numbers: the same everywhere and for ever, uniform, and without memory of any order.
#include <moire/random.h>

#include <array>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <set>
#include <vector>

namespace moire::test {

namespace {

constexpr std::uint64_t step = 0x9e3779b97f4a7c15U;

// Pearson's chi-square of counts that should all be the same.
double chi_square(const std::vector<int>& counts) {
  double sum = 0, square = 0;
  for (const int count : counts) sum += count;
  const double expected = sum / static_cast<double>(counts.size());
  for (const int count : counts) square += (count - expected) * (count - expected) / expected;
  return square;
}

// Laurent and Massart 2000, lemma 1 (doi:10.1214/aos/1015957395): a chi-square of k degrees of freedom exceeds
// k + 2 sqrt(k t) + 2 t with probability e^-t at most, and falls below k - 2 sqrt(k t) likewise. Here e^-t is 10^-6.
constexpr double t = 13.8155;
double largest(double k) { return k + 2 * std::sqrt(k * t) + 2 * t; }
double smallest(double k) { return k - 2 * std::sqrt(k * t); }

constexpr int side = 16;

// Whether pairs of neighbours number(k), number(k + 1) fill the unit square evenly.
template <class Number>
void check_pairs(Number number) {
  std::vector<int> counts(side * side);
  for (std::uint32_t k = 0; k < 100000; ++k) {
    const double a = number(k), b = number(k + 1);
    REQUIRE((a >= 0 && a < 1));
    ++counts[static_cast<std::size_t>(side * static_cast<int>(side * a) + static_cast<int>(side * b))];
  }
  CHECK(chi_square(counts) < largest(side * side - 1));
  CHECK(chi_square(counts) > smallest(side * side - 1));
}

}  // namespace

TEST_CASE("the mixing function is SplitMix64's: its first numbers from seed 0 are the published ones") {
  CHECK(mixed(step) == 0xe220a8397b1dcdafU);
  CHECK(mixed(2 * step) == 0x6e789e6aa1b965f4U);
  CHECK(mixed(3 * step) == 0x06c45d188009454fU);
}

TEST_CASE("random numbers never change: published results depend on them") {
  STATIC_CHECK(random({}, 0, 0) == 0x1.0983a455564p-3);
  STATIC_CHECK(random({3, -2, 7, 11}, 5, 1) == 0x1.2478338a6c4e6p-2);
}

TEST_CASE("each part of the key chooses another number") {
  const Pixel here{10, 20, 30, 40};
  std::set<double> numbers{random(here, 1, 2)};
  for (const Pixel& other : {Pixel{11, 20, 30, 40}, Pixel{10, 21, 30, 40}, Pixel{10, 20, 31, 40}, Pixel{10, 20, 30, 41},
                             Pixel{20, 10, 30, 40}, Pixel{-10, 20, 30, 40}, Pixel{10, -20, 30, 40}}) {
    CHECK(numbers.insert(random(other, 1, 2)).second);
  }
  CHECK(numbers.insert(random(here, 2, 2)).second);
  CHECK(numbers.insert(random(here, 1, 3)).second);
  CHECK(numbers.insert(random(here, 2, 1)).second);
}

TEST_CASE("numbers of neighbours are uniform and know nothing of each other") {
  SECTION("pixels of a row") {
    check_pairs([](std::uint32_t k) { return random({.x = static_cast<int>(k)}, 0, 0); });
  }
  SECTION("pixels of a column") {
    check_pairs([](std::uint32_t k) { return random({.y = static_cast<int>(k)}, 0, 0); });
  }
  SECTION("frames") {
    check_pairs([](std::uint32_t k) { return random({.frame = static_cast<int>(k)}, 0, 0); });
  }
  SECTION("seeds") {
    check_pairs([](std::uint32_t k) { return random({.seed = k}, 0, 0); });
  }
  SECTION("samples") {
    check_pairs([](std::uint32_t k) { return random({}, k, 0); });
  }
  SECTION("dimensions") {
    check_pairs([](std::uint32_t k) { return random({}, 0, k); });
  }
}

TEST_CASE("the order in which numbers are asked for changes none") {
  const auto ask = [](std::uint32_t k) { return random({static_cast<int>(k % 7), 3, 0, 9}, k, k % 3); };
  std::vector<double> forward, backward(100);
  for (std::uint32_t k = 0; k < 100; ++k) forward.push_back(ask(k));
  for (std::uint32_t k = 100; k-- > 0;) backward[k] = ask(k);
  CHECK(backward == forward);
}

}  // namespace moire::test
