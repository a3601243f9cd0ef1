// OpenImageIO's TextureSystem on our textures: what it is given, and what is recorded of it.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <thread>

#include "framework/sampling/looked_up.h"

namespace moire::test {

// OpenImageIO takes places in float textures: off by 2^-24 of two textures, as many texels times a contrast of 1, along
// both axes; its own interpolation rounds floats some ten times.
TEST_CASE("enlarged by OpenImageIO a texture is interpolated as by bilinear, with all wraps and far out") {
  for (const auto& [width, height] : {std::pair{100, 37}, {64, 64}, {1, 1}, {1, 9}}) {
    for (const Wrap wrap : {Wrap::mirror, Wrap::repeat, Wrap::clamp}) {
      const NoiseTexture noise(width, height, wrap);
      const auto own = lookup("oiio", {{"interpolation", std::string("bilinear")}}), bilinear = lookup("bilinear");
      const double tolerance = (width + height) * 0x1p-23 + 10 * 0x1p-24;
      double worst = 0;
      for (int n = 0; n < 200; ++n) {
        const double reach = n % 2 == 0 ? 4.0 * width : 1e6;
        SurfacePoint point = some_place(n, reach);
        point = place(point.s, point.t, 0.25F, 0, 0, 0.25F);
        const LookedUp a = looked_up(*own, point, noise.texture), b = looked_up(*bilinear, point, noise.texture);
        worst = std::max({worst, std::abs(a.sum.r - b.sum.r), std::abs(a.sum.g - b.sum.g)});
      }
      CAPTURE(width, height, static_cast<int>(wrap));
      CHECK(worst <= tolerance);
    }
  }
}

TEST_CASE("OpenImageIO averages footprints: a large one is the texture's mean, one colour stays itself") {
  NoiseTexture noise(64, 64, Wrap::repeat);
  const Pyramid& pyramid = noise.texture.pyramid();
  const float* mean = pyramid.level(pyramid.levels() - 1).rgba.data();
  const float unknown = std::numeric_limits<float>::quiet_NaN();
  for (const char* mip : {"anisotropic", "trilinear", "one_level"}) {
    const auto own = lookup("oiio", {{"mip", std::string(mip)}});
    for (const float way : {1e4F, std::numeric_limits<float>::infinity(), unknown}) {
      const LookedUp found = looked_up(*own, place(3, 5, way, 0, 0, way), noise.texture);
      CAPTURE(mip, way);
      CHECK(std::abs(found.sum.g - static_cast<double>(mean[1])) <= 1e-6);
    }
    NoiseTexture constant(100, 37, Wrap::mirror);
    for (float& value : constant.rgb) value = 0.3F;
    for (int n = 0; n < 100; ++n) {
      REQUIRE(std::abs(looked_up(*own, some_place(n, 500), constant.texture).sum.g - 0.3) <= 1e-6);
    }
  }
}

TEST_CASE("OpenImageIO's options change what it does") {
  const NoiseTexture noise(128, 128, Wrap::repeat);
  const SurfacePoint point = place(40.3, 50.1, 16, 0, 0, 2);
  const double usual = looked_up(*lookup("oiio"), point, noise.texture).sum.r;
  for (const LookupChanges& changes : {LookupChanges{{"mip", std::string("none")}},
                                       {{"mip", std::string("trilinear")}},
                                       {{"mip", std::string("one_level")}},
                                       {{"anisotropic", std::int64_t{2}}},
                                       {{"width", 0.5}}}) {
    CHECK(looked_up(*lookup("oiio", changes), point, noise.texture).sum.r != usual);
  }
  const SurfacePoint enlarged = place(40.3, 50.1, 0.1F, 0, 0, 0.1F);
  for (const char* other : {"bilinear", "closest"}) {
    CHECK(looked_up(*lookup("oiio", {{"interpolation", std::string(other)}}), enlarged, noise.texture).sum.r !=
          looked_up(*lookup("oiio"), enlarged, noise.texture).sum.r);
  }
}

TEST_CASE("of what OpenImageIO reads the texel at the place is recorded, with full weight") {
  const NoiseTexture noise(16, 16, Wrap::repeat);
  const LookedUp found = looked_up(*lookup("oiio"), place(-3.25, 20.5, 4, 0, 0, 4), noise.texture, true, 0.5);
  REQUIRE(found.fragments.size() == 1);
  CHECK(found.fragments[0].element == texel_element(0, -4, 20));
  CHECK(found.fragments[0].weight == 0.5);
  CHECK(found.fragments[0].color == found.color());
}

TEST_CASE("many threads see the same of OpenImageIO") {
  const NoiseTexture noise(100, 37, Wrap::repeat);
  const auto own = lookup("oiio");
  std::vector<std::vector<double>> seen(4);
  std::vector<std::thread> threads;
  for (std::vector<double>& mine : seen) {
    threads.emplace_back([&] {
      for (int n = 0; n < 500; ++n) mine.push_back(looked_up(*own, some_place(n, 500), noise.texture, false).sum.g);
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::vector<double>& mine : seen) CHECK(mine == seen.front());
}

}  // namespace moire::test
