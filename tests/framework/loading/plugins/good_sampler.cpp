// A sampler without fault.
#include <moire/plugin.h>

namespace {

class Middle final : public moire::PointSampler {
 public:
  void points(const moire::Pixel&, moire::Points& out) const override { out.add(0.5, 0.5); }
};

}  // namespace

MOIRE_SAMPLER(good, "1.2.3",
              (moire::SamplerPlugin{
                  .summary = "A sampler without fault.",
                  .source = "None",
                  .make_points = [](const moire::Settings&) -> std::unique_ptr<moire::PointSampler> {
                    return std::make_unique<Middle>();
                  },
              }))
