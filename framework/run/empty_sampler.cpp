#include "run/empty_sampler.h"

namespace moire {

namespace {

class EmptyRendering final : public Rendering {
 public:
  void render(PixelBlock& block) const override {
    block.fill([&](auto add) {
      for (std::size_t slot = 0; slot < block.slots(); ++slot) add(slot, background, 1, Color{});
    });
  }
};

class EmptySampler final : public Sampler {
 public:
  std::unique_ptr<Rendering> begin(const RenderRequest&) const override { return std::make_unique<EmptyRendering>(); }
};

}  // namespace

std::unique_ptr<Sampler> make_empty_sampler() { return std::make_unique<EmptySampler>(); }

}  // namespace moire
