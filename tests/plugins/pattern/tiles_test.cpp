// Patterns of tiles: independent pixels.
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "pattern_frames.h"

namespace moire::test {

namespace {

constexpr ImageSize size{64, 64};

std::vector<double> reds(const Changes& changes) {
  const MadePattern made = made_pattern(changes, size);
  const ExactPixels exact(*made.frame);
  std::vector<double> all;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) all.push_back(exact.red(x, y));
  }
  return all;
}

struct Moments {
  double mean = 0, variance = 0, next = 0;  // next: covariance with the neighbour
};

Moments moments(const std::vector<double>& values) {
  Moments m;
  const auto n = static_cast<double>(values.size());
  for (const double v : values) m.mean += v / n;
  for (std::size_t k = 0; k < values.size(); ++k) {
    m.variance += (values[k] - m.mean) * (values[k] - m.mean) / n;
    m.next += (values[k] - m.mean) * (values[(k + 1) % values.size()] - m.mean) / n;
  }
  return m;
}

const Changes edges{{"kind", std::string("edge")}, {"tile", std::int64_t{1}}};

}  // namespace

TEST_CASE("with tiles of a pixel, every pixel has an upright edge of its own, uniform over its width") {
  const Moments m = moments(reds(edges));
  // A uniform number: mean 1/2, variance 1/12. Five standard deviations of 4096 of them: .0225 of the mean, and of
  // the variance (fourth moment 1/80) .0058.
  CHECK(std::abs(m.mean - 0.5) < 0.0225);
  CHECK(std::abs(m.variance - 1.0 / 12) < 0.0058);
  CHECK(std::abs(m.next) < 5.0 / 12 / 64);
}

TEST_CASE("with edges of any angle, every pixel is crossed by one, and the next pixel's is another") {
  const auto values = reds(with(edges, {{"angles", std::string("any")}}));
  CHECK(std::all_of(values.begin(), values.end(), [](double v) { return v > 0 && v < 1; }));
  const Moments m = moments(values);
  // Coverage is symmetric about 1/2 and its variance is at most 1/4.
  CHECK(std::abs(m.mean - 0.5) < 5 * 0.5 / 64);
  CHECK(std::abs(m.next) < 5 * m.variance / 64);
  CHECK(std::abs(moments(reds(with(edges, {{"angles", std::string("any")}, {"seed", std::int64_t{2}}}))).mean -
                 m.mean) > 0);
}

TEST_CASE("points see the tiles that averages are of") {
  for (const char* kind : {"edge", "disk", "blob"}) {
    const Changes changes{
        {"kind", std::string(kind)}, {"tile", std::int64_t{5}}, {"radius", 2.2}, {"sigma", 1.5}, {"angle_deg", 30.0}};
    const MadePattern made = made_pattern(changes, {13, 12});
    const ExactPixels exact(*made.frame);
    constexpr int n = 64;
    for (int y = 0; y < 12; ++y) {
      for (int x = 0; x < 13; ++x) {
        double sum = 0;
        for (int i = 0; i < n * n; ++i) {
          const SamplePoint point{x + (i % n + 0.5) / n, y + (i / n + 0.5) / n};
          Hit hit;
          Counters counters;
          made.frame->trace({&point, 1}, {&hit, 1}, counters);
          sum += hit.color.r / (n * n);
        }
        CAPTURE(kind, x, y);
        // One border of at most 2 pixels' sides crosses 4 n cells, of which half is wrong at most.
        CHECK(std::abs(sum - exact.red(x, y)) < 2.0 / n);
        CHECK(std::abs(exact.weight(x, y) - 1) < 1e-15);
      }
    }
  }
}

TEST_CASE("a tile's disk lies within half a pixel of its tile's middle") {
  const MadePattern made =
      made_pattern({{"kind", std::string("disk")}, {"tile", std::int64_t{9}}, {"radius", 2.0}}, {90, 90});
  const ExactPixels exact(*made.frame);
  for (int j = 0; j < 10; ++j) {
    for (int i = 0; i < 10; ++i) {
      double area = 0, x_sum = 0;
      for (int y = 9 * j; y < 9 * j + 9; ++y) {
        for (int x = 9 * i; x < 9 * i + 9; ++x) area += exact.red(x, y), x_sum += exact.red(x, y) * (x + 0.5);
      }
      CHECK(std::abs(area - 4 * 3.141592653589793) < 1e-12);
      // Pixels' middles are not those of what is in them, by up to 1/4 pixel at the border.
      CHECK(std::abs(x_sum / area - (9 * i + 4.5)) < 0.5 + 0.1);
    }
  }
}

}  // namespace moire::test
