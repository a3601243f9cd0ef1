// The spectrum pass must give the numbers that the definitions give on paper, and none where components cannot be told
// apart.
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <map>

#include "framework/metrics/waves.h"
#include "metrics/gains.h"
#include "metrics/power.h"
#include "metrics/registry.h"
#include "sanitized.h"

namespace moire::test {

using Catch::Approx;

namespace {

constexpr int side = sanitized ? 128 : 512;
constexpr ImageSize size{side, side};

// No two share a bin or its mirror: in cycles over the picture, folded, all are different.
std::vector<Sinusoid> some_waves() {
  constexpr int bins[][2] = {{9, 3}, {-14, 21}, {30, 0}, {0, 17}, {side + 5, 8}, {40, 2 * side - 33}, {-side - 25, 11}};
  std::vector<Sinusoid> waves;
  for (const auto& [u, v] : bins) {
    const auto k = static_cast<double>(waves.size());
    waves.push_back({0.04 + 0.01 * k, static_cast<double>(u) / side, static_cast<double>(v) / side, 0.7 * k});
  }
  return waves;
}

struct Found : std::map<std::string, double> {
  double low = 0, high = 0;  // of alias
};

Found found(const Picture& picture, const Picture& reference, const Frame& frame,
            std::span<const Picture> replicates = {}, std::int64_t pairs = 1) {
  Settings settings(spectrum_description.parameters);
  settings.set("pairs", pairs);
  const Counters counters;
  const auto metric = make_spectrum(settings);
  Found result;
  for (const Measurement& m : metric->finish({picture, reference, counters, &frame, nullptr, 1, replicates})) {
    result[std::string(m.quantity)] = m.value;
    if (m.quantity == "spectrum.alias") {
      result.low = m.low;
      result.high = m.high;
    }
  }
  return result;
}

// Pixels are floats, off by 2^-25 at most below 1: a gain's error has a deviation of 2 / a * 2^-25 / sqrt(3) /
// sqrt(2 P), and a weighed mean of n of them is off by less.
double tolerance(double smallest_amplitude) {
  return 6 * 2 / smallest_amplitude * 0x1p-25 / std::sqrt(3.0) / (std::sqrt(2.0) * side);
}

}  // namespace

TEST_CASE("point sampling has alias 1 and neither blur, noise nor shift") {
  const auto waves = some_waves();
  const Picture picture = picture_of(size, waves, [](const Sinusoid&) { return 1.0; });
  auto numbers = found(picture, picture, KnownFrame(size, waves));
  const double margin = tolerance(0.04);
  CHECK(std::abs(numbers["spectrum.alias"] - 1) < margin);
  CHECK(std::abs(numbers["spectrum.blur"]) < margin);
  CHECK(numbers["spectrum.noise"] == 0);
  CHECK(std::abs(numbers["spectrum.shift"]) < 10 * margin);  // over 2 pi |f|, f >= 9 / 512
  CHECK(numbers["spectrum.structured"] == 0);
}

TEST_CASE("the exact box has the alias and the blur of its transfer function") {
  const auto waves = some_waves();
  const auto box = [](const Sinusoid& w) { return sinc(w.fx) * sinc(w.fy); };
  const Picture picture = picture_of(size, waves, box);
  double inside = 0, kept = 0, outside = 0, folded_in = 0;
  for (const Sinusoid& w : waves) {
    const double power = w.amplitude * w.amplitude, gain = box(w);
    (is_in_band(w) ? inside : outside) += power;
    (is_in_band(w) ? kept : folded_in) += power * (is_in_band(w) ? gain : gain * gain);
  }
  auto numbers = found(picture, picture, KnownFrame(size, waves));
  CHECK(std::abs(numbers["spectrum.alias"] - folded_in / outside) < tolerance(0.04));
  CHECK(std::abs(numbers["spectrum.blur"] - (1 - kept / inside)) < tolerance(0.04));
}

TEST_CASE("a picture that is moved by a fraction of a pixel is shifted by it, and loses its cosine") {
  const std::vector<Sinusoid> wave{{0.25, 16.0 / side, 0, 0.3}};
  const double by = 0.25, angle = 2 * std::numbers::pi * by * 16 / side;
  std::vector<Sinusoid> moved = wave;
  moved[0].phase += angle;
  const Picture picture = picture_of(size, moved, [](const Sinusoid&) { return 1.0; });
  auto numbers = found(picture, picture, KnownFrame(size, wave));
  CHECK(numbers["spectrum.shift"] == Approx(by).epsilon(1e-6));
  CHECK(numbers["spectrum.blur"] == Approx(1 - std::cos(angle)).margin(tolerance(0.25)));
}

TEST_CASE("noise is no alias: two pictures of independent noise have none, whatever its power") {
  const auto waves = some_waves();
  const auto nothing = [](const Sinusoid&) { return 0.0; };
  std::vector<Picture> pictures(2, picture_of(size, waves, nothing));
  double variance = 0;
  for (std::size_t p = 0; p < pictures.size(); ++p) {
    for (std::size_t k = 0; k < pictures[p].pixels.size(); ++k) {
      const auto noise = static_cast<float>(random({static_cast<int>(k), 0, 0, p}, 0, 0) - 0.5);
      pictures[p].pixels[k] = {0.5F + noise, 0.5F + noise, 0.5F + noise};
    }
  }
  double power = 0, least = 1;
  for (const Sinusoid& w : waves) {
    power += w.amplitude * w.amplitude / 2;
    least = std::min(least, w.amplitude);
  }
  variance = 1.0 / 12;
  const Picture reference = picture_of(size, waves, nothing);
  auto numbers = found(pictures[0], reference, KnownFrame(size, waves), pictures);
  // A gain of noise of variance s^2 has E|T|^2 = 4 s^2 / (a^2 P); the product of two independent ones has mean 0 and a
  // deviation below that.
  CHECK(std::abs(numbers["spectrum.alias"]) < 4 * 4 * variance / (least * least * side * side));
  // The relative deviation of a mean of P squares of (A - B)^2 / 2 is about sqrt(2 / P), times four.
  CHECK(numbers["spectrum.noise"] == Approx(variance / power).epsilon(4 * std::sqrt(2.0) / side));
  CHECK(numbers["spectrum.random_error"] == Approx(255 * std::sqrt(variance)).epsilon(4 * std::sqrt(2.0) / side));
  // (A - R)(B - R): mean 0, deviation s^2 / sqrt(P).
  CHECK(std::abs(numbers["spectrum.structured"]) < 255 * std::sqrt(4 * variance / side));
}

TEST_CASE("the structured part and the noise make up the mean square error") {
  Picture reference{{2, 1}, {{0.5F, 0.5F, 0.5F}, {0.25F, 0.5F, 0.75F}}}, a = reference, b = reference;
  a.pixels[0].r = 0.75F;
  b.pixels[0].r = 0.25F;
  b.pixels[1].g = 1;
  const std::vector<Picture> pictures{a, b};
  const KnownFrame frame(reference.size, {});
  auto numbers = found(a, reference, frame, pictures);
  const auto square = [](double x) { return std::copysign(x * x, x); };
  const auto mean_square = [&](const Picture& p) {
    return square(root_mean_square(differences(p, reference, Space::linear)));
  };
  CHECK(square(numbers["spectrum.structured"]) + square(numbers["spectrum.random_error"]) ==
        Approx((mean_square(a) + mean_square(b)) / 2).epsilon(1e-12));
  CHECK(numbers["spectrum.structured"] < 0);  // errors that point apart
  CHECK_FALSE(numbers.contains("spectrum.alias"));
}

TEST_CASE("more pairs give an interval about their mean") {
  const auto waves = some_waves();
  const auto box = picture_of(size, waves, [](const Sinusoid& w) { return sinc(w.fx) * sinc(w.fy); });
  const auto points = picture_of(size, waves, [](const Sinusoid&) { return 1.0; });
  const std::vector<Picture> pictures{box, box, points, points};
  auto numbers = found(box, box, KnownFrame(size, waves), pictures, 2);
  const double of_box = found(box, box, KnownFrame(size, waves))["spectrum.alias"];
  CHECK(numbers["spectrum.alias"] == Approx((of_box + 1) / 2).epsilon(1e-6));
  CHECK(numbers.high - numbers.low == Approx(2 * 1.96 * (1 - of_box) / 2).epsilon(1e-6));
}

TEST_CASE("components that cannot be told apart have no gains") {
  const Picture grey{{8, 8}, std::vector<Color>(64)};
  const auto wave = [](double u, double v) { return Sinusoid{0.1, u / 8, v / 8, 0}; };
  const auto is_empty = [&](std::vector<Sinusoid> waves) { return gains(grey, waves).empty(); };
  CHECK_FALSE(is_empty({wave(1, 0), wave(2, 0)}));
  CHECK(is_empty({wave(1.5, 0)}));            // no whole number of cycles
  CHECK(is_empty({wave(1, 0), wave(9, 0)}));  // the same bin
  CHECK(is_empty({wave(1, 2), wave(7, 6)}));  // its mirror
  CHECK(is_empty({wave(8, 0)}));              // the constant
  CHECK(is_empty({wave(4, 0)}));              // half a cycle a pixel
}

TEST_CASE("the strongest bin is where the strongest component folds to") {
  const std::vector<Sinusoid> waves{{0.2, 0.8125, 0, 0.1}, {0.05, 0.125, 0.25, 0}};
  constexpr ImageSize small{128, 128};
  const Picture picture = picture_of(small, waves, [](const Sinusoid&) { return 1.0; });
  auto numbers = found(picture, picture, KnownFrame(small, waves));
  CHECK(numbers["spectrum.predicted_peak"] == 0.1875);
  CHECK(numbers["spectrum.peak"] == 0.1875);
}

TEST_CASE("folding takes whole cycles away") {
  CHECK(folded(0.25) == 0.25);
  CHECK(folded(0.75) == -0.25);
  CHECK(folded(2.5) == -0.5);
  CHECK(folded(-1.125) == -0.125);
}

TEST_CASE("the power spectrum holds the power of a picture, each wave in its bins, for any size") {
  for (const ImageSize shape : {ImageSize{12, 10}, {7, 9}, {16, 1}, {1, 5}, {1, 1}}) {
    CAPTURE(shape.width, shape.height);
    std::vector<double> values;
    double square = 0;
    for (int k = 0; k < shape.width * shape.height; ++k) {
      values.push_back(random({k, 0, 0, 3}, 0, 0));
      square += values.back() * values.back();
    }
    double sum = 0;
    for (double bin : power_spectrum(values, shape)) sum += bin;
    CHECK(sum == Approx(square).epsilon(1e-12));  // Parseval
  }
  std::vector<double> wave;
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 8; ++x) wave.push_back(std::cos(2 * std::numbers::pi * (2 * x / 8.0 + y / 6.0)));
  }
  const auto power = power_spectrum(wave, {8, 6});
  for (std::size_t k = 0; k < power.size(); ++k) {
    const bool is_wave = k == 1 * 8 + 2 || k == 5 * 8 + 6;
    CHECK(power[k] == Approx(is_wave ? 48.0 / 4 : 0).margin(1e-12));
  }
  const auto rings = radial_mean(power, {8, 6}, 4);
  double ring_sum = 0;
  for (const Point& p : rings) ring_sum += p.y > 1e-12;
  CHECK(ring_sum == 1);  // both bins are at the same distance
}

}  // namespace moire::test
