// Adaptive sampling on pictures that are known at every point: where it looks again, what it makes of what it saw, and
// what it never sees.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <functional>
#include <set>

#include "framework/sampling/known_points.h"
#include "sampling/lookups.h"
#include "support/plugins.h"

namespace moire::test {

namespace {

constexpr ImageSize size{40, 24};

// What is seen is a function of the point. As a surface all of it is one grey texel, whatever is seen.
class Drawn final : public Frame, public Surface {
 public:
  explicit Drawn(std::function<Hit(Point)> hit, Blend blend = Blend::linear) : hit_(std::move(hit)), blend_(blend) {}

  ImageSize size() const override { return test::size; }
  Blend blend() const override { return blend_; }
  void trace(std::span<const SamplePoint> points, std::span<Hit> hits, Counters& counters) const override {
    counters.queries += points.size();
    for (std::size_t k = 0; k < points.size(); ++k) hits[k] = hit_({points[k].x, points[k].y});
  }
  const Surface* surface() const override { return this; }
  void locate(std::span<const SamplePoint> points, std::span<SurfacePoint> out, Counters& counters) const override {
    counters.queries += points.size();
    for (std::size_t k = 0; k < points.size(); ++k)
      out[k] = {.hit = hit_({points[k].x, points[k].y}), .textured = true, .s = 0.5, .t = 0.5};
  }
  const Texture& texture() const override { return texture_; }

 private:
  std::function<Hit(Point)> hit_;
  Blend blend_;
  std::vector<float> texel_ = std::vector<float>(3, 0.5F);
  Texture texture_{{{texel_.data(), 3, 1, 1}}, Wrap::mirror};
};

constexpr Hit white{1, {1, 1, 1}}, black{2, {}};

// White above a line of this slope and height at x = 0.
Drawn half_plane(double slope, double height) {
  return Drawn([=](Point p) { return p.y < height + slope * p.x ? white : black; });
}

Drawn flat() {
  return Drawn([](Point) { return white; });
}

std::unique_ptr<Sampler> corners(int depth, int first, const Changes& more = {}) {
  Changes changes{{"depth", std::int64_t{depth}}, {"first", std::to_string(first)}};
  changes.insert(changes.end(), more.begin(), more.end());
  return sampler("adaptive", changes);
}
std::unique_ptr<Sampler> two_level(const Changes& more = {}) {
  Changes changes{{"method", std::string("two_level")}};
  changes.insert(changes.end(), more.begin(), more.end());
  return sampler("adaptive", changes);
}

// The trapezoid rule over the whole lattice of n cells along a pixel's side.
double trapezoid(const Frame& frame, int x, int y, int n) {
  double sum = 0;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      const SamplePoint point{x + static_cast<double>(i) / n, y + static_cast<double>(j) / n};
      Hit hit;
      Counters counters;
      frame.trace({&point, 1}, {&hit, 1}, counters);
      sum += hit.color.g * (i % n == 0 ? 0.5 : 1) * (j % n == 0 ? 0.5 : 1);
    }
  }
  return sum / (n * n);
}

std::uint64_t queries(const Sampler& made, const Frame& frame, const Lookup* lookup = nullptr) {
  return rendered(made, frame, lookup).counters.queries;
}

// Of a lattice of n points along a pixel's side over the two blocks that the image makes, with both borders.
std::uint64_t lattice_points(int n) {
  const auto points = [n](int pixels) { return static_cast<std::uint64_t>(pixels * n + 1); };
  return (points(32) + points(size.width - 32)) * points(size.height);
}

}  // namespace

TEST_CASE("where only straight edges pass, corners see what the whole lattice sees, and sum it alike") {
  for (const double slope : {0.0, 0.37, -2.5, 1.0}) {
    const Drawn frame = half_plane(slope, slope < 0 ? 70.3 : 3.21);
    for (const int first : {1, 2, 4}) {
      for (const int depth : {0, 1, 2, 3, 4}) {
        CAPTURE(slope, first, depth);
        const Rendered image = rendered(*corners(depth, first), frame);
        const int finest = std::max(1 << depth, first);
        std::size_t wrong = 0;
        for (int x = 0; x < size.width; ++x) {
          for (int y = 0; y < size.height; ++y) {
            // Sums of powers of two: no rounding.
            if (image.at(x, y).color.g != trapezoid(frame, x, y, finest) || image.at(x, y).weight != 1) ++wrong;
          }
        }
        CHECK(wrong == 0);
        CHECK(image.counters.queries < lattice_points(finest) + (finest == first ? 1 : 0));
      }
    }
  }
}

TEST_CASE("pictures of one colour cost the first lattice, or the few points, and no more") {
  const Drawn frame = flat();
  for (const int first : {1, 2, 4}) CHECK(queries(*corners(6, first), frame) == lattice_points(first));
  // Two blocks of 32 and 8 columns, each with one column of its neighbour.
  CHECK(queries(*two_level(), frame) == (33 + 9) * 24 * 4);
  CHECK(queries(*two_level({{"neighbours", false}}), frame) == 40 * 24 * 4);
}

TEST_CASE("where everything differs it costs the finest lattice, or both levels: at most 1.1 of uniform sampling") {
  const KnownPoints frame(size);
  for (const int first : {1, 4}) {
    for (const int depth : {2, 4}) {
      const std::uint64_t asked = queries(*corners(depth, first), frame);
      const int finest = 1 << depth;
      CHECK(asked == lattice_points(finest));
      CHECK(static_cast<double>(asked) <= 1.1 * size.width * size.height * finest * finest);
    }
  }
  const std::uint64_t asked = queries(*two_level(), frame);
  CHECK(asked == (33 + 9) * 24 * 4 + 40 * 24 * 64);
  CHECK(static_cast<double>(asked) <= 1.1 * size.width * size.height * 64);
}

TEST_CASE("what lies between the first points stays unseen, however deep; a finer first lattice sees it") {
  // A speck of a third of a pixel within pixel (7, 9).
  const Drawn frame([](Point p) { return std::abs(p.x - 7.45) < 0.15 && std::abs(p.y - 9.6) < 0.15 ? white : black; });
  CHECK(rendered(*corners(6, 1), frame).at(7, 9).color == Color{});
  CHECK(rendered(*corners(6, 2), frame).at(7, 9).color.g > 0);
  CHECK(std::abs(rendered(*corners(6, 4), frame).at(7, 9).color.g - 0.09F) < 0.01F);
}

TEST_CASE("colours differ by sRGB codes, elements by being others; either is enough unless it is said") {
  const auto code = [](int level) { return static_cast<float>(srgb_to_linear(level / 255.0)); };
  const auto greys = [&](int lower, int upper, Element element) {
    return Drawn([=, low = code(lower), high = code(upper)](Point p) {
      return p.y < 10.4 ? Hit{1, {low, low, low}} : Hit{element, {low, high, low}};
    });
  };
  const auto is_refined = [](const Frame& frame, const char* criterion, double threshold = 8) {
    const Changes changes{{"criterion", std::string(criterion)}, {"threshold", threshold}};
    const bool by_corners = queries(*corners(3, 1, changes), frame) > lattice_points(1);
    CHECK((queries(*two_level(changes), frame) > (33 + 9) * 24 * 4) == by_corners);
    return by_corners;
  };
  for (const int lower : {0, 100, 246}) {
    CAPTURE(lower);
    const Drawn equal = greys(lower, lower, 2), near = greys(lower, lower + 7, 1), far = greys(lower, lower + 9, 1);
    CHECK_FALSE(is_refined(equal, "color"));
    CHECK(is_refined(equal, "element"));
    CHECK(is_refined(equal, "either"));
    CHECK_FALSE(is_refined(near, "either"));
    CHECK(is_refined(near, "color", 6));
    CHECK(is_refined(far, "color"));
    CHECK(is_refined(far, "either"));
    CHECK_FALSE(is_refined(far, "element"));
  }
  // Colours that are codes are compared as they are.
  const auto stored = [](float high) {
    return Drawn([=](Point p) { return p.y < 10.4 ? Hit{1, {}} : Hit{1, {high, 0, 0}}; }, Blend::as_stored);
  };
  CHECK_FALSE(is_refined(stored(7 / 255.0F), "color"));
  CHECK(is_refined(stored(9 / 255.0F), "color"));
}

TEST_CASE("through a lookup, colours are the lookup's and elements those of the scene") {
  const auto lookup = make_lookup("bilinear");  // sees one grey texel everywhere
  const Drawn frame = half_plane(0.37, 3.21);
  CHECK(queries(*corners(3, 1, {{"criterion", std::string("color")}}), frame, lookup.get()) == lattice_points(1));
  const std::uint64_t by_elements = queries(*corners(3, 1), frame, lookup.get());
  CHECK(by_elements == queries(*corners(3, 1), frame));
  CHECK(by_elements > lattice_points(1));
}

TEST_CASE("in refined pixels one jittered point in each fine cell replaces the few, with random numbers of its own") {
  const KnownPoints frame(size);
  PixelBlock block({0, 0, size.width, size.height}, true);
  two_level()->begin({.frame = frame, .seed = 3})->render(block);
  std::set<std::pair<int, int>> cells;
  std::size_t wrong = 0;
  for_each_point(block, frame, 5, 6, [&](double weight, Point p) {
    cells.emplace(static_cast<int>(8 * (p.x - 5)), static_cast<int>(8 * (p.y - 6)));
    if (weight != 1.0 / 64 || p.x < 5 || p.x >= 6 || p.y < 6 || p.y >= 7) ++wrong;
  });
  CHECK(wrong == 0);
  CHECK(cells.size() == 64);
}

TEST_CASE("neighbours of a pixel that is refined are refined with it, if that is wished") {
  // One pixel differs within itself: every point of it is an element of its own.
  const auto one_pixel = [](int x, int y) {
    return Drawn([=](Point p) {
      const bool inside = std::floor(p.x) == x && std::floor(p.y) == y;
      return Hit{inside ? 1 + static_cast<Element>(1e6 * p.x) : 0, {}};
    });
  };
  struct Place {
    int x, y, around;
  };
  // Around pixel (31, 7) lie pixels of the other block; a corner of the image has three neighbours.
  for (const auto& [x, y, around] : {Place{31, 7, 9}, Place{0, 0, 4}, Place{39, 23, 4}, Place{20, 0, 6}}) {
    CAPTURE(x, y);
    const Drawn frame = one_pixel(x, y);
    CHECK(queries(*two_level(), frame) == (33 + 9) * 24 * 4 + static_cast<std::uint64_t>(around) * 64);
    CHECK(queries(*two_level({{"neighbours", false}}), frame) == 40 * 24 * 4 + 64);
  }
}

TEST_CASE("the mean over seeds of two levels is without bias where every pixel is refined") {
  // Mean of y in pixel (3, 2) over 400 seeds: each seed's error has variance 1 / (12 * 8^2 * 64), of 64 cells.
  double sum = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const KnownPoints frame(size);
    PixelBlock block({3, 0, 1, 3}, true);
    two_level({{"neighbours", false}})->begin({.frame = frame, .seed = seed})->render(block);
    for_each_point(block, frame, 3, 2, [&](double weight, Point p) { sum += weight * (p.y - 2.5); });
  }
  CHECK(std::abs(sum / 400) < 4 * std::sqrt(1.0 / (12 * 64 * 64 * 400)));
}

}  // namespace moire::test
