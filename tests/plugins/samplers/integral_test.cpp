// The sampler that asks a scene for its own averages.
#include <catch2/catch_test_macros.hpp>

#include "sampling/filters.h"
#include "support/plugins.h"

namespace moire::test {

namespace {

// Its bound is the largest x of a block; its grey says whether it was given a filter.
class Bounded final : public Frame, public Averages {
 public:
  ImageSize size() const override { return {100, 3}; }
  void trace(std::span<const SamplePoint>, std::span<Hit>, Counters&) const override {}
  const Averages* averages() const override { return this; }
  double integrate(const Filter* filter, PixelBlock& block) const override {
    for (std::size_t slot = 0; slot < block.slots(); ++slot)
      block.add(slot, 1, 1, filter ? Color{0.5F, 0.5F, 0.5F} : Color{1, 1, 1});
    return block.x0 == 32 ? 1e-3 : 1e-6;
  }
};

}  // namespace

TEST_CASE("integral states the largest bound of all blocks, on any threads") {
  const Bounded frame;
  const auto integral = sampler("integral");
  for (const int threads : {1, 2}) {
    const auto rendering = integral->begin({.frame = frame});
    CHECK(rendering->error_bound() == 0);
    const Rendered image = rendered(*rendering, frame, {.threads = threads, .order = Blocks::columns});
    CHECK(rendering->error_bound() == 1e-3);
    CHECK(image.at(99, 2).color == Color{1, 1, 1});
  }
}

TEST_CASE("integral hands on the filter") {
  const Bounded frame;
  const auto tent = make_tent(1);
  const auto rendering = sampler("integral")->begin({.frame = frame, .filter = tent.get()});
  CHECK(rendered(*rendering, frame).at(0, 0).color.r == 0.5F);
}

TEST_CASE("integral is an exact reference of scenes that know their averages, and of no others") {
  const SamplerPlugin& plugin = sampler_plugin("integral");
  Settings settings(plugin.parameters);
  CHECK(plugin.reference(Questions::points | Questions::averages, 2, settings) == Trust::exact);
  CHECK(plugin.reference(Questions::points | Questions::lines, 2, settings) == Trust::none);
}

}  // namespace moire::test
