// A sampler that finds out too late that it cannot do its work.
#include <stdexcept>

#include <moire/plugin.h>

namespace {

class Throws final : public moire::PointSampler {
 public:
  void points(const moire::Pixel&, moire::Points&) const override { throw std::runtime_error("the table is empty"); }
};

}  // namespace

MOIRE_SAMPLER(throws_in_points, "1.0.0",
              (moire::SamplerPlugin{
                  .summary = "Throws when it is asked for points.",
                  .source = "",
                  .make_points = [](const moire::Settings&) -> std::unique_ptr<moire::PointSampler> {
                    return std::make_unique<Throws>();
                  },
              }))
