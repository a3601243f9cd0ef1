// One point a pixel, its colour interpolated between the four nearest texels. Texels that are hidden take part too:
// the coverage metric shows them as leak.
#include <moire/plugin.h>

namespace {

class Bilinear final : public moire::PointSampler {
 public:
  void points(const moire::Pixel&, moire::Points& out) const override { out.add(0.5, 0.5); }
  bool same_in_every_pixel() const override { return true; }
};

}  // namespace

MOIRE_SAMPLER(
    bilinear, "1.0.0",
    (moire::SamplerPlugin{
        .summary = "One point in the middle of each pixel, interpolated between the four nearest texels.",
        .source = "Cohen-Or 1997, sections 3 and 4.1 (eq. 4 is its one-dimensional form, lookup linear_across)",
        .lookup = "bilinear",
        .make_points = [](const moire::Settings&) -> std::unique_ptr<moire::PointSampler> {
          return std::make_unique<Bilinear>();
        },
    }))
