// One point in the middle of each pixel: the method that aliases most, and the yardstick of cost.
#include <moire/plugin.h>

namespace {

class Point final : public moire::PointSampler {
 public:
  void points(const moire::Pixel&, moire::Points& out) const override { out.add(0.5, 0.5); }
  bool same_in_every_pixel() const override { return true; }
};

}  // namespace

MOIRE_SAMPLER(point, "1.0.0",
              (moire::SamplerPlugin{
                  .summary = "One point in the middle of each pixel.",
                  .source = "Cohen-Or 1997, section 4.1: PS",
                  .make_points = [](const moire::Settings&) -> std::unique_ptr<moire::PointSampler> {
                    return std::make_unique<Point>();
                  },
              }))
