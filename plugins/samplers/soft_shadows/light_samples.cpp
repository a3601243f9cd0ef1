// Soft shadows pixel by pixel: points of the light, looked at from the pixel's middle.
#include <moire/plugin.h>
#include <moire/reseed.h>

#include "light_points.h"

namespace {

using namespace moire::parameter;

constexpr moire::Parameter parameters[] = {
    integer("n", 4, 1, 256, "points", "root of the number of points of the light: n x n in each pixel"),
    choice("pattern", "rotated", soft_shadows::patterns,
           "lattice and grid are the same in every pixel, as an average of n x n hard shadows; the others are random "
           "in each: a jittered grid, independent points, a lattice moved as a whole"),
    moire::Reseed::parameter,
};

class LightSamples final : public moire::PointSampler {
 public:
  explicit LightSamples(const moire::Settings& settings)
      : n_(static_cast<std::uint32_t>(settings.integer("n"))),
        pattern_(soft_shadows::pattern_of(settings.text("pattern"))),
        reseed_(settings) {}

  void points(const moire::Pixel& pixel, moire::Points& out) const override {
    for (const moire::LightPoint light : soft_shadows::light_points(pattern_, n_, reseed_.key(pixel))) {
      out.add_lit(0.5, 0.5, light);
    }
  }
  bool same_in_every_pixel() const override { return !soft_shadows::is_random(pattern_); }
  std::optional<moire::Spacing> spacing() const override { return moire::Spacing{}; }

 private:
  std::uint32_t n_;
  soft_shadows::Pattern pattern_;
  moire::Reseed reseed_;
};

}  // namespace

MOIRE_SAMPLER(
    light_samples, "1.0.0",
    (moire::SamplerPlugin{
        .summary = "Points of an area light, in one of five patterns, seen from each pixel's middle.",
        .source = "Jang 1997, \"Shadows\": average of hard shadows; Cook 1986, doi:10.1145/7529.8927: one set "
                  "a pixel",
        .parameters = parameters,
        .asks = [](const moire::Settings&) { return moire::Questions::points | moire::Questions::receivers; },
        .claims = {.deterministic = false},
        .make_points = [](const moire::Settings& settings) -> std::unique_ptr<moire::PointSampler> {
          return std::make_unique<LightSamples>(settings);
        },
    }))
