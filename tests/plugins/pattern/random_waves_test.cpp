// Generated sinusoids: their rules, held to sums over pixels.
#include "random_waves.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>

#include "message_of.h"

namespace moire::test {

namespace {

// In pixels' middles.
std::vector<double> sampled(const Sinusoid& s, ImageSize size) {
  std::vector<double> result;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x)
      result.push_back(std::cos(2 * std::numbers::pi * (s.fx * (x + 0.5) + s.fy * (y + 0.5)) + s.phase));
  }
  return result;
}

double mean_product(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
  return sum / static_cast<double>(a.size());
}

}  // namespace

TEST_CASE("generated sinusoids keep their rules in images of odd, even and small sizes") {
  for (const ImageSize size : {ImageSize{128, 128}, {45, 38}, {31, 64}, {17, 17}, {200, 3}}) {
    CAPTURE(size.width, size.height);
    const pattern::RandomWaves wanted{40, 40, 0.13, 7};
    const std::vector<Sinusoid> waves = pattern::random_waves(wanted, size);
    REQUIRE(waves.size() == 80);
    double power = 0;
    std::vector<std::vector<double>> samples;
    for (std::size_t k = 0; k < waves.size(); ++k) {
      const Sinusoid& s = waves[k];
      const double x = s.fx * size.width, y = s.fy * size.height, frequency = std::max(std::abs(s.fx), std::abs(s.fy));
      CHECK(std::abs(x - std::nearbyint(x)) < 1e-12);
      CHECK(std::abs(y - std::nearbyint(y)) < 1e-12);
      if (k < 40) {
        CHECK(frequency <= 0.45);
      } else {
        CHECK(frequency >= 0.55);
        CHECK(frequency <= 3);
      }
      // Neither folds to Nyquist's frequency.
      CHECK(std::abs(std::abs(std::remainder(s.fx, 1)) - 0.5) > 1e-9);
      CHECK(std::abs(std::abs(std::remainder(s.fy, 1)) - 0.5) > 1e-9);
      power += s.amplitude * s.amplitude / 2;
      samples.push_back(sampled(s, size));
    }
    CHECK(std::abs(std::sqrt(power) - 0.13) < 1e-15);
    // No two share a frequency in pixels, none is constant: their samples are orthogonal, to each other and to 1.
    const std::vector<double> one(samples[0].size(), 1.0);
    for (std::size_t a = 0; a < samples.size(); ++a) {
      CHECK(std::abs(mean_product(samples[a], one)) < 1e-12);
      CHECK(std::abs(mean_product(samples[a], samples[a]) - 0.5) < 1e-12);
      if (size.width == 128 && a % 8 != 0) continue;
      for (std::size_t b = 0; b < a; ++b) CHECK(std::abs(mean_product(samples[a], samples[b])) < 1e-12);
    }
  }
}

TEST_CASE("generated sinusoids depend on seed and size alone") {
  const auto first = [](std::uint64_t seed, ImageSize size) { return pattern::random_waves({5, 5, 1, seed}, size)[0]; };
  const Sinusoid a = first(1, {64, 64}), same = first(1, {64, 64}), other = first(2, {64, 64});
  CHECK(a.fx == same.fx);
  CHECK(a.phase == same.phase);
  CHECK(a.phase != other.phase);
}

TEST_CASE("an image that is too small for so many sinusoids is refused") {
  CHECK(message_of([] {
          pattern::random_waves({40, 40, 0.1, 1}, {8, 8});
        }) ==
        "pattern: 40 + 40 sinusoids of frequencies that pixels tell apart find no place in an image of 8 x 8 pixels "
        "(24 did); take a larger image, or fewer of components_in and components_out");
  CHECK(message_of([] {
          pattern::random_waves({1, 0, 0.1, 1}, {1, 1});
        }) ==
        "pattern: 1 + 0 sinusoids of frequencies that pixels tell apart find no place in an image of 1 x 1 pixels "
        "(0 did); take a larger image, or fewer of components_in and components_out");
}

}  // namespace moire::test
