// Averages by the quadtree: within the bound that it reports, of what clipping each texel gives.
#include <catch2/catch_test_macros.hpp>

#include "plugins/textured_plane/compared.h"
#include "sanitized.h"

namespace moire::test {
namespace {

constexpr double rounding = 1e-12;

struct Averaged {
  PixelBlock block;
  double bound;
};

Averaged quadtree_of(const Camera& camera, const Texels& texels, PixelArea area, double tolerance, bool recording) {
  Averaged result{PixelBlock(area, recording), 0};
  const textured_plane::View view(camera);
  result.bound = textured_plane::Quadtree(view, texels, nothing, tolerance).integrate(result.block);
  return result;
}

}  // namespace

TEST_CASE("the quadtree is no farther from clipping each texel than it says, and records what clipping gives") {
  int bounded = 0, wrong = 0;
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirror, Wrap::clamp}) {
    const Texels texels = random_texels(13, 9, wrap);
    for (const Camera& camera : turned_views()) {
      if (sanitized && camera.far > 30) continue;
      for (int y = 0; y < camera.size.height; ++y) {
        for (int x = 0; x < camera.size.width; ++x) {
          CAPTURE(static_cast<int>(wrap), camera.height, camera.pitch_deg, camera.yaw_deg, camera.roll_deg, x, y);
          const Clipped exact = clipped(camera, texels, x, y);
          for (const double tolerance : {1e-4, 0.3}) {
            const Averaged a = quadtree_of(camera, texels, {x, y, 1, 1}, tolerance, true);
            const double error = color_error(a.block.sum(0), exact);
            REQUIRE(error <= a.bound + rounding);
            REQUIRE(weight_error(a.block, 0, exact) <= rounding);
            REQUIRE(std::abs(a.block.weight(0) - 1) <= rounding);
            bounded += a.bound > 0;
            wrong += error > rounding;
          }
        }
      }
    }
  }
  // Else nothing would have been bounded.
  const int enough = sanitized ? 20 : 100;
  CHECK(bounded > enough);
  CHECK(wrong > enough);
}

TEST_CASE("the quadtree agrees with strips where both can be had") {
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirror, Wrap::clamp}) {
    const Texels texels = random_texels(7, 5, wrap);
    for (const Camera& camera : aligned_views()) {
      PixelBlock strips({0, 0, camera.size.width, camera.size.height}, false);
      const textured_plane::View view(camera);
      textured_plane::Strips(view, texels, nothing).integrate(strips);
      const Averaged tree = quadtree_of(camera, texels, {0, 0, camera.size.width, camera.size.height}, 1e-9, false);
      for (std::size_t k = 0; k < strips.slots(); ++k) {
        CAPTURE(camera.height, camera.pitch_deg, camera.yaw_deg, k);
        const Tally::Sum &a = strips.sum(k), &b = tree.block.sum(k);
        REQUIRE(std::abs(a.r - b.r) <= tree.bound + rounding);
        REQUIRE(std::abs(a.g - b.g) <= tree.bound + rounding);
        REQUIRE(std::abs(a.b - b.b) <= tree.bound + rounding);
        REQUIRE(std::abs(a.weight - b.weight) <= rounding);
      }
    }
  }
}

TEST_CASE("the quadtree's pixels have the same bits in a block of any shape, recorded or not") {
  const Texels texels = random_texels(13, 9, Wrap::mirror);
  for (const Camera& camera : turned_views()) {
    const Averaged whole = quadtree_of(camera, texels, {0, 0, camera.size.width, camera.size.height}, 1e-2, false);
    for (int y = 0; y < camera.size.height; ++y) {
      for (int x = 0; x < camera.size.width; ++x) {
        const Averaged alone = quadtree_of(camera, texels, {x, y, 1, 1}, 1e-2, true);
        REQUIRE(alone.block.sum(0) == whole.block.sum(whole.block.slot(x, y)));
        REQUIRE(alone.bound <= whole.bound);
      }
    }
  }
}

}  // namespace moire::test
