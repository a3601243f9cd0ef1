// One point a pixel: the method that aliases most, and the yardstick of cost.
#include <moire/plugin.h>

namespace {

using namespace moire::parameter;

constexpr moire::Parameter parameters[] = {
    choice("rays", "centre", "centre lower_edge", "the point lies in the pixel's middle, or on its lower edge"),
};

class Point final : public moire::PointSampler {
 public:
  explicit Point(const moire::Settings& settings) : y_(settings.text("rays") == "centre" ? 0.5 : moire::lower_edge) {}

  void points(const moire::Pixel&, moire::Points& out) const override { out.add(0.5, y_); }
  bool same_in_every_pixel() const override { return true; }

 private:
  double y_;
};

}  // namespace

MOIRE_SAMPLER(point, "1.0.0",
              (moire::SamplerPlugin{
                  .summary = "One point in each pixel.",
                  .source = "Cohen-Or 1997, section 4.1: PS",
                  .parameters = parameters,
                  .make_points = [](const moire::Settings& settings) -> std::unique_ptr<moire::PointSampler> {
                    return std::make_unique<Point>(settings);
                  },
              }))
