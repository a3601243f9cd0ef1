// A sampler that takes its time: a third of a second for a block of 32 x 32 pixels.
#include <chrono>
#include <thread>

#include <moire/plugin.h>

namespace {

class Slow final : public moire::PointSampler {
 public:
  void points(const moire::Pixel&, moire::Points& out) const override {
    std::this_thread::sleep_for(std::chrono::microseconds(300));
    out.add(0.5, 0.5);
  }
};

}  // namespace

MOIRE_SAMPLER(slow, "1.0.0",
              (moire::SamplerPlugin{
                  .summary = "Takes its time.",
                  .source = "",
                  .make_points = [](const moire::Settings&) -> std::unique_ptr<moire::PointSampler> {
                    return std::make_unique<Slow>();
                  },
              }))
