// The error that the convergence pass reports is over all replicates, and its interval covers the truth as often as it
// says.
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include <moire/random.h>
#include "metrics/registry.h"

namespace moire::test {

using Catch::Approx;

namespace {

struct Interval {
  double value, low, high;
};

Interval rmse_of(const std::vector<Picture>& pictures, const Picture& reference) {
  Settings settings(convergence_description.parameters);
  settings.set("replicates", static_cast<std::int64_t>(pictures.size()));
  const Counters counters{.queries = 4 * reference.pixels.size()};
  for (const Measurement& m :
       make_convergence(settings)->finish({pictures.front(), reference, counters, nullptr, nullptr, 1, pictures})) {
    if (m.quantity == "convergence.rmse") return {m.value, m.low, m.high};
    CHECK(m.quantity == "convergence.samples");
    CHECK(m.value == 4);
  }
  return {};
}

}  // namespace

TEST_CASE("the error is a root mean square over pixels, channels and replicates, 1 full scale") {
  const ImageSize size{64, 64};
  const Picture reference{size, std::vector<Color>(64 * 64)};
  Picture half = reference, all = reference;
  for (Color& c : half.pixels) c = {0.5F, 0.5F, 0.5F};
  for (Color& c : all.pixels) c = {1, 1, 1};
  CHECK(rmse_of({half}, reference).value == Approx(0.5).epsilon(1e-12));
  CHECK(rmse_of({half, all}, reference).value ==
        Approx(std::sqrt((0.25 + 1) / 2)).epsilon(1e-3));  // groups differ in size
}

TEST_CASE("intervals hold the true error about as often as they say") {
  const ImageSize size{32, 32};
  const Picture reference{size, std::vector<Color>(32 * 32)};
  constexpr int trials = 200;
  int held = 0;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<Picture> pictures(2, reference);
    for (std::size_t p = 0; p < pictures.size(); ++p) {
      for (std::size_t k = 0; k < pictures[p].pixels.size(); ++k) {
        const auto noise = static_cast<float>(random({static_cast<int>(k), trial, 0, p}, 0, 0) - 0.5);
        pictures[p].pixels[k] = {noise, noise, noise};
      }
    }
    const Interval found = rmse_of(pictures, reference);
    held += found.low <= std::sqrt(1.0 / 12) && std::sqrt(1.0 / 12) <= found.high;
  }
  // Of 200 trials at 95 %: 190, deviation 3.1.
  CHECK(held >= 190 - 4 * 3.1);
  CHECK(held <= trials);
}

}  // namespace moire::test
