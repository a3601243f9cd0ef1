// A sampler that fails in the second frame of an animation.
#include <stdexcept>

#include <moire/plugin.h>

namespace {

class Black final : public moire::Rendering {
 public:
  void render(moire::PixelBlock& block) const override {
    for (std::size_t slot = 0; slot < block.slots(); ++slot) block.add(slot, moire::background, 1, {});
  }
};

class Throws final : public moire::Sampler {
 public:
  std::unique_ptr<moire::Rendering> begin(const moire::RenderRequest& request) const override {
    if (request.frame_number == 1) throw std::runtime_error("no sequels");
    return std::make_unique<Black>();
  }
};

}  // namespace

MOIRE_SAMPLER(throws_in_frame_1, "1.0.0",
              (moire::SamplerPlugin{
                  .summary = "Is black, and throws in frame 1.",
                  .source = "",
                  .make = [](const moire::Settings&) -> std::unique_ptr<moire::Sampler> {
                    return std::make_unique<Throws>();
                  },
              }))
