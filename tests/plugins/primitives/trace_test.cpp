// What points see, held to distances in long double.
#include <catch2/catch_test_macros.hpp>

#include <moire/random.h>

#include "plugins/primitives/brute_force.h"

namespace moire::test {
namespace {

// In the image and up to 60 pixels beyond it, where no cells are.
std::vector<Point> random_points(int count, ImageSize size, std::uint64_t seed) {
  std::vector<Point> points;
  for (int k = 0; k < count; ++k) {
    const auto draw = [&](std::uint32_t dimension) { return random({.x = k, .seed = seed}, 1, dimension); };
    points.push_back({(size.width + 120) * draw(0) - 60, (size.height + 120) * draw(1) - 60});
  }
  return points;
}

// Points of which the element is another one than distances say; those too near an outline to tell are left out.
int wrong_points(const std::vector<primitives::Curve>& curves, ImageSize size, const std::vector<Point>& points) {
  // Coordinates are below 1,000; aside() has an error below 8 * 2^-53 * 1,000 pixels, the square of a distance twice
  // that.
  constexpr long double unsure = 1e-11L;
  const auto elements = elements_at(*frame_of(curves, size), points);
  int wrong = 0, told = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto seen = seen_at(curves, points[k], unsure);
    told += seen ? 1 : 0;
    wrong += seen && *seen != elements[k] ? 1 : 0;
  }
  CHECK(told > static_cast<int>(points.size()) - 3);
  return wrong;
}

}  // namespace

TEST_CASE("points see the foremost of lines and circles, in the image and around it") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    const ImageSize size{90, 61};
    CHECK(wrong_points(random_curves(30, size, seed), size, random_points(4000, size, seed)) == 0);
  }
}

TEST_CASE("points see the foremost of ten thousand lines and circles") {
  const ImageSize size{320, 200};
  CHECK(wrong_points(random_curves(10000, size, 7), size, random_points(2000, size, 7)) == 0);
}

TEST_CASE("points see thin curves far larger than the image where they pass it") {
  // Coordinates of 1e7: places in double are exact to 2e-9 pixels, distances to 1e-8.
  const ImageSize size{64, 48};
  const std::vector<primitives::Curve> curves{
      LineCurve{1, {}, {-9.9e6, -3.1e6}, {9.9e6 + 64, 3.1e6 + 50}, 0.4, Cap::butt},
      CircleCurve{2, {}, {30, 9.9999e6 + 20}, 9.9999e6, 3},
      LineCurve{3, {}, {12.3, -1e7}, {13.1, 1e7}, 0.7, Cap::round},
      CircleCurve{4, {}, {-1e7, 17}, 1e7 + 44.5, 0.9},
  };
  const auto frame = frame_of(curves, size);
  int seen[5] = {};
  for (const Point p : random_points(20000, size, 3)) {
    const auto element = seen_at(curves, p, 4e-8L);
    if (!element) continue;
    ++seen[*element];
    CHECK(elements_at(*frame, {p}).front() == *element);
  }
  for (int k = 1; k < 5; ++k) CHECK(seen[k] > 20);
}

TEST_CASE("what is traced is counted") {
  const auto frame = frame_of({CircleCurve{1, {}, {5, 5}, 0, 4}}, {10, 10});
  const std::vector<SamplePoint> points{{5, 5}, {5.5, 6}, {8, 8}};
  std::vector<Hit> hits(3);
  Counters counters;
  frame->trace(points, hits, counters);
  CHECK(counters == Counters{.queries = 3, .hits = 2});
}

}  // namespace moire::test
