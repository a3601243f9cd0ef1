#include "random_waves.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <fmt/format.h>
#include <moire/error.h>
#include <moire/random.h>

namespace pattern {

namespace {

constexpr double below_nyquist = 0.45, above_nyquist = 0.55, highest = 3;
constexpr std::uint32_t most_trials =
    10000;  // for each wave: where 1 place in 100 is free, none of them finds it once in e^100

struct Bin {
  int x, y;  // cycles an image
  friend auto operator<=>(const Bin&, const Bin&) = default;
};

// The frequency at which pixels show one, of the two that differ by their sign the one with the larger x.
Bin folded(Bin bin, moire::ImageSize size) {
  const auto wrapped = [](int k, int n) { return ((k % n) + n) % n; };
  const Bin one{wrapped(bin.x, size.width), wrapped(bin.y, size.height)};
  return std::max(one, Bin{wrapped(-bin.x, size.width), wrapped(-bin.y, size.height)});
}

class Drawer {
 public:
  Drawer(const RandomWaves& wanted, moire::ImageSize size) : wanted_(wanted), size_(size) {}

  std::vector<moire::Sinusoid> draw() {
    const int all = wanted_.in_band + wanted_.out_of_band;
    const double amplitude = wanted_.rms * std::sqrt(2.0 / std::max(all, 1));
    std::vector<moire::Sinusoid> waves;
    for (int k = 0; k < all; ++k) {
      const bool in_band = k < wanted_.in_band;
      const Bin bin =
          free_place(static_cast<std::uint32_t>(k), in_band ? 0 : above_nyquist, in_band ? below_nyquist : highest);
      waves.push_back({amplitude, static_cast<double>(bin.x) / size_.width, static_cast<double>(bin.y) / size_.height,
                       2 * std::numbers::pi * random(static_cast<std::uint32_t>(k), 0)});
    }
    return waves;
  }

 private:
  double random(std::uint32_t wave, std::uint32_t use) const {
    return moire::random({.x = 0, .y = 0, .frame = 0, .seed = wanted_.seed}, wave, use);
  }
  // Uniform in -largest .. largest.
  static int integer(double random, int largest) {
    return static_cast<int>(std::floor(random * (2 * largest + 1))) - largest;
  }

  Bin free_place(std::uint32_t wave, double low, double high) {
    for (std::uint32_t trial = 0; trial < most_trials; ++trial) {
      const Bin bin{integer(random(wave, 1 + 2 * trial), static_cast<int>(high * size_.width)),
                    integer(random(wave, 2 + 2 * trial), static_cast<int>(high * size_.height))};
      const double frequency = std::max(std::abs(static_cast<double>(bin.x) / size_.width),
                                        std::abs(static_cast<double>(bin.y) / size_.height));
      const Bin shown = folded(bin, size_);
      const bool is_nyquist = 2 * shown.x == size_.width || 2 * shown.y == size_.height;
      if (frequency < low || is_nyquist || shown == Bin{0, 0}) continue;
      if (taken_.insert(shown).second) return bin;
    }
    throw moire::Error(fmt::format(
        "pattern: {} + {} sinusoids of frequencies that pixels tell apart find no place in an image of {} x {} pixels "
        "({} did); take a larger image, or fewer of components_in and components_out",
        wanted_.in_band, wanted_.out_of_band, size_.width, size_.height, taken_.size()));
  }

  RandomWaves wanted_;
  moire::ImageSize size_;
  std::set<Bin> taken_;
};

}  // namespace

std::vector<moire::Sinusoid> random_waves(const RandomWaves& wanted, moire::ImageSize size) {
  return Drawer(wanted, size).draw();
}

}  // namespace pattern
