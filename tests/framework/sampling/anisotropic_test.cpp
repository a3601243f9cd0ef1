// Anisotropic lookups, put together from mip-mapped ones.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <set>

#include "framework/sampling/looked_up.h"

namespace moire::test {
namespace {

// One read that is `width` texels wide.
SurfacePoint square(double s, double t, double width) {
  const auto side = static_cast<float>(width);
  return place(s, t, side, 0, 0, side);
}

struct Reads {
  int count;
  double width;
};

}  // namespace

// The width as a float moves the level by 2^-24 / ln 2; sums of up to 64 differences, of at most 1, round by 2^-24
// each.
TEST_CASE("anisotropic is the mean of mip-mapped reads in a row along the longer derivative") {
  const NoiseTexture noise(100, 37, Wrap::repeat);
  const auto mipmap = lookup("mipmap");
  for (const int most : {1, 4, 16, 64}) {
    const auto own = lookup("anisotropic", {{"probes", std::int64_t{most}}});
    double worst = 0;
    std::set<int> counts;
    for (int n = 0; n < 400; ++n) {
      const SurfacePoint point = some_place(n, 400);
      const double across = std::hypot(point.ds_dx, point.dt_dx), down = std::hypot(point.ds_dy, point.dt_dy);
      const double longer = std::max(across, down), shorter = std::max(1.0, std::min(across, down));
      const Reads reads = longer > most * shorter
                              ? Reads{most, longer / most}
                              : Reads{std::max(1, static_cast<int>(std::round(longer / shorter))), shorter};
      counts.insert(reads.count);
      const double ds = across > down ? point.ds_dx : point.ds_dy, dt = across > down ? point.dt_dx : point.dt_dy;
      double red = 0;
      for (int k = 0; k < reads.count; ++k) {
        const double along = (2 * k + 1 - reads.count) / (2.0 * reads.count);
        red += looked_up(*mipmap, square(point.s + along * ds, point.t + along * dt, reads.width), noise.texture, false)
                   .sum.r /
               reads.count;
      }
      const double found = looked_up(*own, point, noise.texture, false).sum.r;
      worst = std::max(worst, std::abs(found - red));
    }
    CAPTURE(most);
    CHECK(worst <= (2 * most + 4) * 0x1p-24);
    CHECK(counts.contains(1));
    CHECK(counts.contains(most));
  }
}

TEST_CASE("a footprint as long as wide is trilinear mip-mapping, bit for bit") {
  const NoiseTexture noise(127, 63, Wrap::mirror);
  const auto own = lookup("anisotropic"), mipmap = lookup("mipmap");
  for (int n = 0; n < 300; ++n) {
    SurfacePoint point = some_place(n, 600);
    point.ds_dy = -point.dt_dx;
    point.dt_dy = point.ds_dx;
    REQUIRE(looked_up(*own, point, noise.texture, false).sum.r ==
            looked_up(*mipmap, point, noise.texture, false).sum.r);
  }
}

TEST_CASE("a long thin footprint is averaged over its length and no wider") {
  // Stripes along s, four texels to a period: a footprint across twenty of them sees grey, one along a stripe its
  // colour.
  NoiseTexture stripes(64, 64, Wrap::repeat);
  for (std::size_t k = 0; k < stripes.rgb.size(); ++k) stripes.rgb[k] = k / 3 / 64 / 2 % 2 == 0 ? 0.0F : 1.0F;
  const auto own = lookup("anisotropic"), mipmap = lookup("mipmap");
  CHECK(looked_up(*own, place(32, 3, 16, 0, 0, 1), stripes.texture).color().r == 1.0F);
  CHECK(std::abs(looked_up(*own, place(32, 3, 1, 0, 0, 16), stripes.texture).color().r - 0.5F) <= 1e-6F);
  CHECK(std::abs(looked_up(*mipmap, place(32, 3, 16, 0, 0, 1), stripes.texture).color().r - 0.5F) <= 1e-6F);
}

TEST_CASE("fragments of a long footprint lie along it") {
  const NoiseTexture noise(64, 64, Wrap::repeat);
  const LookedUp found = looked_up(*lookup("anisotropic"), place(10.5, 20.5, 8, 0, 0, 1), noise.texture);
  // Eight reads, a texel apart, between 6.5 and 14.5: each between two texels' middles.
  for (const Fragment& f : found.fragments) {
    const TexelIndex texel = texel_index(f.element);
    CHECK(texel.level == 0);
    CHECK(texel.j == 20);
    CHECK((texel.i >= 6 && texel.i <= 14));
    CHECK(f.weight == (texel.i == 6 || texel.i == 14 ? 1.0 / 16 : 1.0 / 8));
  }
  CHECK(found.fragments.size() == 9);
}

}  // namespace moire::test
