// Patterns under filters, held to the filters' own definitions: tables, transfer functions, moments.
#include "sampling/filtered_rendering.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <complex>
#include <numbers>

#include "framework/sampling/known_points.h"
#include "framework/sampling/pattern.h"
#include "message_of.h"
#include "metrics/registry.h"
#include "sampling/filters.h"
#include "sampling/pattern_sampler.h"
#include "support/plugins.h"

namespace moire::test {

namespace {

constexpr double pi = std::numbers::pi;
using Complex = std::complex<double>;

std::unique_ptr<Sampler> filtered(std::string_view name, const Changes& changes, const FilterChoice& filter) {
  const SamplerPlugin& plugin = sampler_plugin(name);
  return make_sampler(plugin, changed(plugin.parameters, changes), filter);
}

std::unique_ptr<Sampler> grid(int n, const FilterChoice& filter) {
  return filtered("supersample", {{"n", std::int64_t{n}}, {"layout", std::string("grid")}}, filter);
}

PixelBlock rendered_block(const Sampler& sampler, const Frame& frame, std::uint64_t seed = 0) {
  PixelBlock block({0, 0, frame.size().width, frame.size().height}, true);
  sampler.begin({.frame = frame, .seed = seed})->render(block);
  return block;
}

// What a point at offset (x, y) from a pixel's middle counts in it.
struct Tap {
  double weight, x, y;
};

// The taps of a pixel from the definition: all points of the plane that are 1 / n apart, with one at the pixel's middle
// if the filter is centred on points, or none on its border lines.
std::vector<Tap> taps_of(const FilterChoice& choice, int n) {
  const auto filter = make_filter(choice.name, choice.settings, 1.0 / n);
  const double radius = filter ? filter->radius() : 0.5;
  const double phase = n % 2 == 1 || is_centred_on_points(choice.name) ? 0 : 0.5;
  std::vector<Tap> taps;
  double sum = 0;
  const int most = static_cast<int>(radius * n) + 2;
  for (int i = -most; i <= most; ++i) {
    for (int j = -most; j <= most; ++j) {
      const double x = (i + phase) / n, y = (j + phase) / n;
      const bool is_in_pixel = std::abs(x) < 0.5 && std::abs(y) < 0.5;
      const double weight = filter ? filter->at(x) * filter->at(y) : is_in_pixel ? 1 : 0;
      sum += weight;
      if (weight != 0) taps.push_back({weight, x, y});
    }
  }
  for (Tap& tap : taps) tap.weight /= sum;
  return taps;
}

// Cycles a pixel; multiples of 1/16, two of them beyond what pixels can show.
constexpr Point frequencies[] = {
    {3 / 16.0, 1 / 16.0}, {-5 / 16.0, 7 / 16.0}, {13 / 16.0, 2 / 16.0}, {-4 / 16.0, 27 / 16.0}};
constexpr ImageSize image{16, 16};

Complex wave(Point frequency, double x, double y) {
  return std::polar(1.0, 2 * pi * (frequency.x * x + frequency.y * y));
}

// Of the closed form: the mean of a wave over the taps, which the pixel's middle is the origin of.
Complex expected_gain(const std::vector<Tap>& taps, Point frequency) {
  Complex gain = 0;
  for (const Tap& tap : taps) gain += tap.weight * wave(frequency, tap.x, tap.y);
  return gain;
}

// What remains of cos(2 pi f.x + phase) at the bin to which it folds: 2 / P sum of I[m] exp(-i (2 pi f.(m + 1/2) +
// phase)) over all pixels m, the pixels' values computed in doubles from the weights that the rendering gave.
Complex measured_gain(const std::vector<double>& picture, Point frequency, double phase) {
  Complex gain = 0;
  for (int x = 0; x < image.width; ++x) {
    for (int y = 0; y < image.height; ++y) {
      gain += picture[static_cast<std::size_t>(x * image.height + y)] *
              std::conj(wave(frequency, x + 0.5, y + 0.5) * std::polar(1.0, phase));
    }
  }
  return gain * (2.0 / (image.width * image.height));
}

std::vector<double> picture_of(const PixelBlock& block, const KnownPoints& frame, Point frequency, double phase) {
  std::vector<double> picture;
  for (int x = 0; x < image.width; ++x) {
    for (int y = 0; y < image.height; ++y) {
      double value = 0;
      for_each_point(block, frame, x, y, [&](double weight, Point p) {
        value += weight * (wave(frequency, p.x, p.y) * std::polar(1.0, phase)).real();
      });
      picture.push_back(value);
    }
  }
  return picture;
}

FilterChoice choice(std::string_view name, const Changes& changes) {
  const auto filter = std::find_if(filters().begin(), filters().end(), [&](const auto& f) { return f.name == name; });
  return {std::string(name), changed(filter->parameters, changes)};
}

double sinc(double x) { return x == 0 ? 1 : std::sin(pi * x) / (pi * x); }

}  // namespace

TEST_CASE("Bartlett windows over the points that they belong to are the lecture's tables") {
  struct Window {
    const char* name;
    int n;
    std::vector<int> row;
    int sum;  // of the table
  };
  const Window windows[] = {{"bartlett_3", 2, {1, 2, 1}, 16},
                            {"bartlett_5", 3, {1, 2, 3, 2, 1}, 81},
                            {"bartlett_7", 4, {1, 2, 3, 4, 3, 2, 1}, 256}};
  for (const auto& [name, n, row, sum] : windows) {
    CAPTURE(name);
    const KnownPoints frame({5, 4});
    const PixelBlock block = rendered_block(*grid(n, {name, {}}), frame);
    const int reach = static_cast<int>(row.size()) / 2;
    std::size_t count = 0, wrong = 0;
    for_each_point(block, frame, 2, 1, [&](double weight, Point p) {
      const double i = (p.x - 2.5) * n, j = (p.y - 1.5) * n;
      if (std::abs(i - std::round(i)) > 1e-12 || std::abs(j - std::round(j)) > 1e-12) ++wrong;
      const auto entry = [&](double k) { return row.at(static_cast<std::size_t>(std::lround(k) + reach)); };
      if (std::abs(weight - static_cast<double>(entry(i) * entry(j)) / sum) > 1e-15) ++wrong;
      ++count;
    });
    CHECK(count == row.size() * row.size());
    CHECK(wrong == 0);
  }
}

TEST_CASE("a filtered grid gives every sinusoid the gain of its taps, in band and beyond") {
  std::vector<FilterChoice> all{choice("gaussian", {{"gaussian.sigma", 0.7}}),
                                choice("mitchell", {{"mitchell.b", 0.0}, {"mitchell.c", 0.5}}),
                                choice("lanczos", {{"lanczos.lobes", std::int64_t{2}}})};
  for (const NamedSummary& filter : filters()) all.push_back({std::string(filter.name), {}});
  for (const FilterChoice& filter : all) {
    for (const int n : {1, 2, 3, 4}) {
      CAPTURE(filter.name, n);
      const KnownPoints frame(image);
      const PixelBlock block = rendered_block(*grid(n, filter), frame);
      const auto taps = taps_of(filter, n);
      double farthest = 0;
      for (std::size_t k = 0; k < std::size(frequencies); ++k) {
        const double phase = 0.3 + static_cast<double>(k);
        const Complex gain = measured_gain(picture_of(block, frame, frequencies[k], phase), frequencies[k], phase);
        farthest = std::max(farthest, std::abs(gain - expected_gain(taps, frequencies[k])));
      }
      CHECK(farthest < 1e-12);
    }
  }
}

TEST_CASE("a column of points is filtered along both axes, by the spacing of each") {
  for (const char* rays : {"centre", "lower_edge"}) {
    CAPTURE(rays);
    const KnownPoints frame({3, 3});
    const Changes changes{{"n", std::int64_t{2}}, {"rays", std::string(rays)}};
    const PixelBlock block = rendered_block(*filtered("supersample", changes, {"bartlett_3", {}}), frame);
    std::map<std::pair<long, long>, double> weights;  // by offsets in spacings: 1 across, 1/2 down
    for_each_point(block, frame, 1, 1, [&](double weight, Point p) {
      weights[{std::lround(p.x - 1.5), std::lround(2 * (p.y - 1.5))}] += weight;
    });
    REQUIRE(weights.size() == 9);
    for (const auto& [offset, weight] : weights)
      CHECK(std::abs(weight - static_cast<double>((2 - std::abs(offset.first)) * (2 - std::abs(offset.second))) / 16) <
            1e-15);
  }
}

TEST_CASE("jitter takes what its sinc leaves of the gain, and gives noise what is lost") {
  constexpr int rounds = 24;  // independent pairs of pictures
  for (const char* name : {"box", "bartlett_7", "gaussian", "mitchell"}) {
    for (const double amount : {0.5, 1.0}) {
      const int n = 4;
      const FilterChoice filter{name, {}};
      const auto sampler = filtered("jittered", {{"n", std::int64_t{n}}, {"amount", amount}}, filter);
      const auto taps = taps_of(filter, n);
      double squares = 0;
      for (const Tap& tap : taps) squares += tap.weight * tap.weight;
      for (const Point frequency : {frequencies[1], frequencies[2]}) {
        CAPTURE(name, amount, frequency.x, frequency.y);
        const double left = sinc(amount * frequency.x / n) * sinc(amount * frequency.y / n);
        std::vector<double> gains, noises;
        for (int round = 0; round < rounds; ++round) {
          std::vector<double> pictures[2];
          for (int k = 0; k < 2; ++k) {
            const KnownPoints frame(image);
            const auto seed = static_cast<std::uint64_t>(2 * round + k);
            pictures[k] = picture_of(rendered_block(*sampler, frame, seed), frame, frequency, 0.7);
            gains.push_back(measured_gain(pictures[k], frequency, 0.7).real());
          }
          double difference = 0;
          for (std::size_t m = 0; m < pictures[0].size(); ++m)
            difference += std::pow(pictures[0][m] - pictures[1][m], 2);
          noises.push_back(difference / (2 * static_cast<double>(pictures[0].size())));
        }
        const auto mean_and_error = [](const std::vector<double>& values) {
          double sum = 0, squared = 0;
          for (const double v : values) sum += v, squared += v * v;
          const auto count = static_cast<double>(values.size());
          return std::pair{sum / count, std::sqrt((squared / count - std::pow(sum / count, 2)) / (count - 1))};
        };
        const auto [gain, gain_error] = mean_and_error(gains);
        const auto [noise, noise_error] = mean_and_error(noises);
        CHECK(std::abs(gain - left * expected_gain(taps, frequency).real()) < 4 * gain_error);
        CHECK(std::abs(noise - squares / 2 * (1 - left * left)) < 4 * noise_error);
      }
    }
  }
}

TEST_CASE("points are shared: a block looks at its own pixels and at those within the filter's reach, once") {
  const KnownPoints frame({6, 5});
  PixelBlock block({2, 0, 3, 5}, false);
  grid(2, {"mitchell", {}})->begin({.frame = frame})->render(block);
  CHECK(block.counters.queries == (3 + 2 * 2) * (5 + 2 * 2) * 4);
}

TEST_CASE(
    "negative lobes leave negative fragments, weights that sum to 1, and coverage that counts them against leak") {
  const KnownPoints frame({4, 4});
  const PixelBlock block = rendered_block(*grid(4, {"mitchell", {}}), frame);
  double sum = 0, negative = 0;
  for_each_point(block, frame, 1, 2, [&](double weight, Point) {
    sum += weight;
    negative += std::min(weight, 0.0);
  });
  CHECK(std::abs(sum - 1) < 1e-14);
  double expected = 0;
  for (const Tap& tap : taps_of({"mitchell", {}}, 4)) expected += std::min(tap.weight, 0.0);
  CHECK(std::abs(negative - expected) < 1e-14);
  CHECK(negative < -0.05);

  // One visible element that has 5/4 of a pixel, and a hidden one that has the rest, -1/4.
  PixelBlock own({0, 0, 1, 1}, true), exact({0, 0, 1, 1}, true);
  own.add(0, 1, 1.25, {});
  own.add(0, 2, -0.25, {});
  exact.add(0, 1, 1, {});
  Settings settings(coverage_description.parameters);
  settings.set("against", std::string("pixel"));
  const auto coverage = make_coverage(settings);
  coverage->begin({1, 1});
  coverage->block(own, MergedBlock(exact));
  std::map<std::string, double> values;
  const Picture picture{{1, 1}, {Color{}}};
  for (const Measurement& m : coverage->finish({picture, picture, Counters{}}))
    values[std::string(m.quantity)] = m.value;
  CHECK(values.at("coverage.leak") == -0.25);
  CHECK(values.at("coverage.weight_error") == 0.25);
}

TEST_CASE("points of unequal weights keep them under a filter") {
  const SamplerPlugin plugin{.summary = "", .source = "", .make_points = [](const Settings&) {
                               return std::unique_ptr<PointSampler>(std::make_unique<Pattern>(
                                   std::vector<Points::Entry>{{0.5, 0.25, 3}, {0.5, 0.75, 1}}));
                             }};
  const auto filter =
      choice("tent", {{"tent.radius", 0.5}});  // a point a quarter from the middle counts half, and none further out
  const KnownPoints frame({1, 1});
  const PixelBlock block = rendered_block(*make_sampler(plugin, Settings(), filter), frame);
  std::vector<std::pair<double, double>> found;
  for_each_point(block, frame, 0, 0, [&](double weight, Point p) { found.emplace_back(p.y, weight); });
  CHECK(found == std::vector<std::pair<double, double>>{{0.75, 0.25}, {0.25, 0.75}});
}

TEST_CASE("a filter that finds no points says in which pixel, and what to do") {
  const auto filter = choice("gaussian", {{"gaussian.sigma", 0.001}});
  const KnownPoints frame({2, 2});
  CHECK(message_of([&] { rendered_block(*grid(2, filter), frame); }) ==
        "pixel (0, 0): the filter gives the points around it weights that sum to 0; the sum is a finite number other "
        "than 0: take more points, or a wider filter");
  CHECK(message_of([&] { rendered_block(*grid(3, filter), frame); }) == "(no error)");
}

}  // namespace moire::test
