// Averages along strips, held to every texel clipped to the pixel.
//
// The goal is 1e-12: edges between texels are a few units in the last place of a pixel's coordinate off, 1e-14 of a
// pixel here, and a pixel has a few hundred of them at most.
#include <catch2/catch_test_macros.hpp>

#include "plugins/textured_plane/compared.h"
#include "sanitized.h"

namespace moire::test {
namespace {

constexpr double tolerance = 1e-12;

PixelBlock strips_of(const Camera& camera, const Texels& texels, PixelArea area, bool recording,
                     Blocks order = Blocks::columns) {
  PixelBlock block(area, recording, order);
  textured_plane::Strips(textured_plane::View(camera), texels, nothing).integrate(block);
  return block;
}

}  // namespace

TEST_CASE("strips give every pixel of the plane what clipping each texel gives") {
  int textured = 0;
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirror, Wrap::clamp}) {
    const Texels texels = random_texels(7, 5, wrap);
    for (const Camera& camera : aligned_views()) {
      if (sanitized && camera.far > 30) continue;
      const PixelBlock block = strips_of(camera, texels, {0, 0, camera.size.width, camera.size.height}, true);
      for (int y = 0; y < camera.size.height; ++y) {
        for (int x = 0; x < camera.size.width; ++x) {
          CAPTURE(static_cast<int>(wrap), camera.height, camera.pitch_deg, camera.yaw_deg, x, y);
          const std::size_t slot = block.slot(x, y);
          const Clipped exact = clipped(camera, texels, x, y);
          textured += exact.r > 0;
          REQUIRE(color_error(block.sum(slot), exact) <= tolerance);
          REQUIRE(weight_error(block, slot, exact) <= tolerance);
          REQUIRE(std::abs(block.weight(slot) - 1) <= tolerance);
        }
      }
    }
  }
  CHECK(textured > 1000);
}

TEST_CASE("strips of a pixel have the same bits in a block of any shape, recorded or not") {
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirror, Wrap::clamp}) {
    const Texels texels = random_texels(7, 5, wrap);
    for (const Camera& camera : aligned_views()) {
      const ImageSize size = camera.size;
      const PixelBlock whole = strips_of(camera, texels, {0, 0, size.width, size.height}, false);
      const PixelBlock rows = strips_of(camera, texels, {0, 2, size.width, size.height - 2}, false, Blocks::rows);
      for (int y = 2; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
          CAPTURE(camera.height, camera.pitch_deg, camera.yaw_deg, x, y);
          const PixelBlock alone = strips_of(camera, texels, {x, y, 1, 1}, true);
          REQUIRE(alone.sum(0) == whole.sum(whole.slot(x, y)));
          REQUIRE(alone.sum(0) == rows.sum(rows.slot(x, y)));
        }
      }
    }
  }
}

}  // namespace moire::test
