// A real photograph under the view that its speed is measured in.
#include <catch2/catch_test_macros.hpp>
#include <cstdlib>
#include <numbers>

#include "plugins/textured_plane/compared.h"
#include "sanitized.h"
#include "support/plugins.h"

namespace moire::test {

TEST_CASE("pixels of a photograph on the plane are what clipping each of its texels gives") {
  const char* const data = std::getenv("MOIRE_DATA");
  if (!data) SKIP("MOIRE_DATA is not set; point it at the data folder to test on a photograph");
  Settings settings = changed(scene_plugin("textured_plane").parameters,
                              {{"texture", std::string(data) + "/texture/naip_airfield_1024.png"}});
  const auto texels = textured_plane::load_texels(settings);
  Camera camera{.size = {512, 512},
                .x = 300.3,
                .y = 100.7,
                .height = 100,
                .far = 50000,
                .fov_deg = 2 * std::atan(0.512) * 180 / std::numbers::pi};
  for (const double yaw : {0.0, 34.0}) {
    camera.yaw_deg = yaw;
    const textured_plane::PlaneFrame frame(camera, *texels, {0, 0, 0}, 1e-4);
    for (const int y : {272, 290, 340, 420, 511}) {
      for (const int x : {3, 255, 400}) {
        if (sanitized && y < 300) continue;
        CAPTURE(yaw, x, y);
        PixelBlock block({x, y, 1, 1}, true);
        const double bound = frame.averages()->integrate(nullptr, block);
        const Clipped exact = clipped(camera, *texels, x, y);
        CHECK(color_error(block.sum(0), exact) <= bound + 1e-12);
        CHECK(weight_error(block, 0, exact) <= 1e-12);
        CHECK(bound <= 1e-4);
      }
    }
  }
}

}  // namespace moire::test
