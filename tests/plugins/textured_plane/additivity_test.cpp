// A pixel is the mean of its four quarters, which are pixels of a picture twice as large.
#include <catch2/catch_test_macros.hpp>

#include "plugins/textured_plane/compared.h"

namespace moire::test {

TEST_CASE("a pixel of the plane is the mean of its quarters, in any view") {
  std::vector<Camera> views = aligned_views();
  const std::vector<Camera> turned = turned_views();
  views.insert(views.end(), turned.begin(), turned.end());
  for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
    const Texels texels = random_texels(7, 5, wrap);
    for (const Camera& camera : views) {
      Camera finer = camera;
      finer.size = {2 * camera.size.width, 2 * camera.size.height};
      const textured_plane::PlaneFrame one(camera, texels, {0.2F, 0.4F, 0.8F}, 1e-3);
      const textured_plane::PlaneFrame other(finer, texels, {0.2F, 0.4F, 0.8F}, 1e-3);
      PixelBlock whole({0, 0, camera.size.width, camera.size.height}, false);
      PixelBlock quarters({0, 0, finer.size.width, finer.size.height}, false);
      const double bound =
          one.averages()->integrate(nullptr, whole) + other.averages()->integrate(nullptr, quarters) + 1e-12;
      for (int y = 0; y < camera.size.height; ++y) {
        for (int x = 0; x < camera.size.width; ++x) {
          CAPTURE(camera.height, camera.pitch_deg, camera.yaw_deg, camera.roll_deg, x, y);
          Tally::Sum sum;
          for (const int a : {0, 1}) {
            for (const int b : {0, 1}) sum.add(quarters.sum(quarters.slot(2 * x + a, 2 * y + b)));
          }
          const Tally::Sum& pixel = whole.sum(whole.slot(x, y));
          REQUIRE(std::abs(pixel.r - sum.r / 4) <= bound);
          REQUIRE(std::abs(pixel.g - sum.g / 4) <= bound);
          REQUIRE(std::abs(pixel.b - sum.b / 4) <= bound);
          REQUIRE(std::abs(pixel.weight - sum.weight / 4) <= 1e-12);
        }
      }
    }
  }
}

}  // namespace moire::test
