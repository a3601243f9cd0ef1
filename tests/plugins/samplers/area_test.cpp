// Area sampling: weights fill every pixel exactly, and more lines converge to what many independent points see.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include <moire/random.h>

#include "plugins/heightfield/views.h"

namespace moire::test {
namespace {

Changes lines(const char* layout, int count) {
  return {{"layout", std::string(layout)}, {"lines", std::int64_t{count}}};
}

// All images of a sampler fill their pixels: weights sum to 1 before division.
void check_weights(const Sampler& sampler, const SmallTerrain& terrain, const std::vector<View>& views) {
  for (View view : views) {
    for (const ImageSize size : {view.size, ImageSize{7, 31}, ImageSize{33, 1}, ImageSize{1, 1}}) {
      view.size = size;
      CAPTURE(view.caption, view.yaw, view.pitch, size.width, size.height);
      const Rendered image = rendered(sampler, *terrain.frame(view), nullptr, {.recording = false});
      double worst = 0;
      for (const Content& pixel : image.pixels) {
        const double off = std::abs(pixel.weight - 1);
        if (!(off <= worst)) worst = off;  // not a number, too
      }
      CHECK(worst <= 1e-12);
    }
  }
}

// Colours of many images of independent points, one in each of side x side cells of every pixel: means and the variance
// of the means, channel after channel.
struct Estimate {
  std::vector<double> mean, variance;
};

Estimate many_points(const Frame& frame, int side, int repetitions) {
  const ImageSize size = frame.size();
  Estimate result;
  std::vector<SamplePoint> points;
  std::vector<Hit> hits;
  Counters counters;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      double sum[3] = {}, squares[3] = {};
      for (int repetition = 0; repetition < repetitions; ++repetition) {
        points.clear();
        for (int k = 0; k < side * side; ++k) {
          const Pixel pixel{x, y, repetition, 11};
          const auto sample = static_cast<std::uint32_t>(k);
          points.push_back(
              {x + (k % side + random(pixel, sample, 0)) / side, y + (k / side + random(pixel, sample, 1)) / side});
        }
        hits.resize(points.size());
        frame.trace(points, hits, counters);
        double mean[3] = {};
        for (const Hit& hit : hits) {
          const float rgb[3] = {hit.color.r, hit.color.g, hit.color.b};
          for (int c = 0; c < 3; ++c) mean[c] += rgb[c] / static_cast<double>(hits.size());
        }
        for (int c = 0; c < 3; ++c) {
          sum[c] += mean[c];
          squares[c] += mean[c] * mean[c];
        }
      }
      for (int c = 0; c < 3; ++c) {
        const double mean = sum[c] / repetitions;
        result.mean.push_back(mean);
        result.variance.push_back(std::max(0.0, squares[c] / repetitions - mean * mean) / (repetitions - 1));
      }
    }
  }
  return result;
}

std::vector<double> channels(const Rendered& image) {
  std::vector<double> values;
  for (const Content& pixel : image.pixels) {
    for (const float value : {pixel.color.r, pixel.color.g, pixel.color.b}) values.push_back(value);
  }
  return values;
}

double mean_square(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum / static_cast<double>(a.size());
}

double mean_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] - b[k];
  return sum / static_cast<double>(a.size());
}

}  // namespace

TEST_CASE("weights of area sampling sum to 1 in every pixel of every view") {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  for (const char* layout : {"upright", "radial"}) {
    for (const int count : {1, 2, 3, 8}) {
      CAPTURE(layout, count);
      const auto area = sampler("area", lines(layout, count));
      check_weights(*area, terrain, views_all_round());
      check_weights(*area, terrain, awkward_views(map));
    }
  }
}

TEST_CASE("a terrain and sky of one colour look like that colour, however they are sampled") {
  Map map = usual_map();
  const Color color = parse_color("#b8d4f0");
  std::fill(map.colors.begin(), map.colors.end(), color);
  const SmallTerrain terrain(map);
  for (const View& view : awkward_views(usual_map())) {
    CAPTURE(view.caption, view.yaw, view.pitch);
    for (const char* layout : {"upright", "radial"}) {
      const Rendered image = rendered(*sampler("area", lines(layout, 2)), *terrain.frame(view));
      const auto differs = [&](const Content& pixel) {
        return !(std::abs(pixel.color.r - color.r) <= 1e-6F && std::abs(pixel.color.b - color.b) <= 1e-6F);
      };
      CHECK(std::count_if(image.pixels.begin(), image.pixels.end(), differs) == 0);
    }
  }
}

// The error of area sampling falls as 1 / lines or faster, so that of 64 lines is at most what separates it from 32.
// What is left is the error of the points, known from the spread of their repetitions: the mean square distance must be
// what both explain. Four standard deviations of a mean of n squares of normal numbers are 4 sqrt(2 / n); the 3
// channels of a pixel are counted as one number, its colours not being independent.
TEST_CASE("area sampling on more and more radial lines converges to what many independent points see") {
  const Map map = usual_map();
  const SmallTerrain terrain(map);
  constexpr int repetitions = 8, side = 12;
  std::vector<View> views;
  for (const auto& [yaw, pitch, fov] : {std::tuple{33.0, -40.0, 60.0},
                                        {200.0, -5.0, 30.0},
                                        {120.0, -85.0, 60.0},
                                        {290.0, 12.0, 70.0},
                                        {45.0, -90.0, 50.0}}) {
    views.push_back(
        {.caption = "", .x = 3.3, .y = 5.7, .z = 9, .yaw = yaw, .pitch = pitch, .fov = fov, .size = {17, 14}});
  }
  for (const View& view : views) {
    CAPTURE(view.yaw, view.pitch, view.fov);
    const auto frame = terrain.frame(view, {{"coherence", std::string("none")}});
    const Estimate points = many_points(*frame, side, repetitions);
    double variance = 0;
    for (const double v : points.variance) variance += v / static_cast<double>(points.variance.size());

    std::vector<std::vector<double>> images;
    for (const int count : {1, 4, 16, 32, 64}) {
      images.push_back(
          channels(rendered(*sampler("area", lines("radial", count)), *frame, nullptr, {.recording = false})));
    }
    const double quadrature = mean_square(images[3], images[4]);
    const auto pixels = static_cast<double>(view.size.width * view.size.height);
    CHECK(mean_square(images[1], points.mean) < mean_square(images[0], points.mean));
    CHECK(mean_square(images[4], points.mean) <= variance * (1 + 4 * std::sqrt(2 / pixels)) + quadrature);
    // No bias: the sum of all differences is that of independent numbers of known variance.
    CHECK(std::abs(mean_difference(images[4], points.mean)) <=
          4 * std::sqrt(variance / pixels) + std::abs(mean_difference(images[3], images[4])));
  }
}

}  // namespace moire::test
