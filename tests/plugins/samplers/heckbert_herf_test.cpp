// Radiance textures on a frame whose irradiance is written down.
#include <atomic>
#include <cmath>

#include "support/plugins.h"

namespace moire::test {

namespace {

constexpr ImageSize size{40, 20};

// The left half of the image is receiver 0, the right half but for its last columns receiver 1; (s, t) run over a half
// as x and y do. A light point brings irradiance 4 where s > u, else 0, and on receiver 1 as much as t.
class Halves final : public Frame, private Receivers {
 public:
  ImageSize size() const override { return test::size; }
  const Receivers* receivers() const override { return this; }
  void trace(std::span<const SamplePoint>, std::span<Hit>, Counters&) const override {}

  mutable std::atomic<int> made = 0;
  mutable IrradianceMap last;

 private:
  static constexpr int sky_columns = 4;
  std::uint32_t count() const override { return 2; }
  Extent extent(std::uint32_t receiver) const override { return receiver == 0 ? Extent{6, 3} : Extent{1, 4}; }
  void locate(std::span<const SamplePoint> points, std::span<ReceiverPoint> out, Counters&) const override {
    for (std::size_t k = 0; k < points.size(); ++k) {
      const auto [x, y, u, v] = points[k];
      const double half = test::size.width / 2.0;
      if (x > test::size.width - sky_columns) {
        out[k] = {.hit = {background, {0, 0, 1}}};
      } else {
        out[k] = {x < half ? 0U : 1U, std::fmod(x, half) / half, y / test::size.height};
      }
    }
  }
  void add_hard_shadows(std::uint32_t receiver, std::span<const LightPoint> lights, ShadowEdges edges,
                        IrradianceMap& map) const override {
    CHECK(edges == ShadowEdges::by_middle);
    ++made;
    for (int j = 0; j < map.rows; ++j) {
      for (int i = 0; i < map.columns; ++i) {
        const double s = (i + 0.5) / map.columns, t = (j + 0.5) / map.rows;
        double sum = 0;
        for (const LightPoint light : lights) sum += receiver == 1 ? t : s > static_cast<double>(light.u) ? 4 : 0;
        map.cells[static_cast<std::size_t>(j * map.columns + i)] +=
            static_cast<float>(sum / static_cast<double>(lights.size()));
      }
    }
    if (receiver == 1) last = map;
  }
  Hit shaded(std::uint32_t receiver, double irradiance) const override {
    return {receiver + 1, {static_cast<float>(irradiance), 0, 0}};
  }
};

std::unique_ptr<Sampler> textured(const char* interpolation, std::int64_t texels, std::int64_t n,
                                  std::int64_t pixel_points = 1, const char* pattern = "grid") {
  return sampler("heckbert_herf", {{"interpolation", std::string(interpolation)},
                                   {"texels", texels},
                                   {"n", n},
                                   {"pixel_points", pixel_points},
                                   {"pattern", std::string(pattern)},
                                   {"edges", std::string("by_middle")}});
}

}  // namespace

TEST_CASE("a texture is the average of its hard shadows, one for each point of the light") {
  const Halves frame;
  // Sixteen points at u = 1/8, 3/8, 5/8, 7/8: the irradiance rises by 1 at each of them.
  const Rendered image = rendered(*textured("nearest", 20, 4), frame);
  for (int x = 0; x < 20; ++x) {
    INFO(x);
    const double s = (x + 0.5) / 20;
    const auto passed = static_cast<float>((s > 0.125) + (s > 0.375) + (s > 0.625) + (s > 0.875));
    CHECK(image.at(x, 3).color.r == passed);
    REQUIRE(image.at(x, 3).fragments.size() == 1);
    CHECK(image.at(x, 3).fragments[0].element == 1);
  }
  CHECK(image.at(39, 3).fragments[0].element == background);
  CHECK(image.at(39, 3).color == Color{0, 0, 1});
}

TEST_CASE("texels are square, whatever shape the receiver has, and each texture is made once") {
  const Halves frame;
  rendered(*textured("nearest", 20, 2), frame, nullptr, {.threads = 4, .block_width = 3});
  CHECK(frame.made == 2);
  CHECK(frame.last.rows == 20);
  CHECK(frame.last.columns == 5);
}

TEST_CASE("between the middles of texels irradiance is linear, and beyond the last ones constant") {
  const Halves frame;
  const Rendered image = rendered(*textured("bilinear", 8, 1), frame);
  for (int y = 0; y < size.height; ++y) {
    INFO(y);
    // Receiver 1 has t at the middles of 8 texels; floats and their products err by some 1e-7.
    const double t = (y + 0.5) / size.height, expected = std::min(std::max(t, 1.0 / 16), 15.0 / 16);
    CHECK(std::abs(static_cast<double>(image.at(25, y).color.r) - expected) < 5e-7);
  }
}

TEST_CASE("pixels of several points average their textures, with all their weights 1 in sum") {
  const Halves frame;
  const Rendered image = rendered(*textured("nearest", 40, 1, 4), frame);
  // The light's one point is at u = 1/2, in the middle of the half: pixel 10 begins there.
  CHECK(image.at(9, 0).color.r == 0);
  CHECK(image.at(10, 0).color.r == 4);
  CHECK(image.at(10, 0).fragments.size() == 16);
  CHECK(image.at(10, 0).weight == 1);
  // Pixel 36's four columns lie between 36 and 37: all see the sky.
  CHECK(image.at(36, 0).color == Color{0, 0, 1});
}

TEST_CASE("random points of the light change with the seed, and with nothing else") {
  const Halves frame;
  const auto jittered = textured("nearest", 40, 3, 1, "jittered");
  const Rendered one = rendered(*jittered, frame, nullptr, {}, 1);
  CHECK(first_difference(one, rendered(*jittered, frame, nullptr, {.threads = 3, .block_width = 7}, 1)).empty());
  CHECK_FALSE(first_difference(one, rendered(*jittered, frame, nullptr, {}, 2)).empty());
}

}  // namespace moire::test
