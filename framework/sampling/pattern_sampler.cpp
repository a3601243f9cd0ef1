#include "sampling/pattern_sampler.h"

#include <optional>

#include <moire/probe.h>

#include "sampling/filtered_rendering.h"
#include "sampling/filters.h"
#include "sampling/spacing.h"
#include "sampling/strands.h"

namespace moire {

namespace {

class PatternRendering final : public Rendering {
 public:
  PatternRendering(const PointSampler& sampler, const RenderRequest& request, LightSeed light_seed)
      : sampler_(sampler), request_(request), light_seed_(light_seed), spacing_(spacing_of(sampler, request)) {}

  void render(PixelBlock& block) const override {
    std::optional<Strands> strands;
    Probe probe(request_, spacing_);
    for (int x = block.x0; x < block.x0 + block.width; ++x) {
      if (strands && sampler_.same_in_every_pixel() && !light_seed_) {
        strands->move_to(x);
      } else {
        strands.emplace(sampler_, Pixel{x, 0, request_.frame_number, request_.seed}, block.y0, block.height,
                        light_seed_);
      }
      const std::size_t base = block.slot(x, block.y0);
      for (const Strand& strand : strands->all()) {
        probe.see(
            strand.points, block, [&](std::size_t k) { return base + strand.rows[k]; },
            [&](std::size_t k) { return strand.weights[k]; });
      }
    }
  }

 private:
  const PointSampler& sampler_;
  RenderRequest request_;
  LightSeed light_seed_;
  Spacing spacing_;
};

class PatternSampler final : public Sampler {
 public:
  PatternSampler(std::unique_ptr<PointSampler> points, const FilterChoice& filter, bool is_deterministic)
      : points_(std::move(points)), filter_(filter), is_deterministic_(is_deterministic) {}
  std::unique_ptr<Rendering> begin(const RenderRequest& request) const override {
    const LightSeed light_seed = light_seed_of(request, is_deterministic_);
    if (filter_.name == filters().front().name) {
      return std::make_unique<PatternRendering>(*points_, request, light_seed);
    }
    return std::make_unique<FilteredRendering>(*points_, request, filter_, light_seed);
  }

 private:
  std::unique_ptr<PointSampler> points_;
  FilterChoice filter_;
  bool is_deterministic_;
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(const SamplerPlugin& plugin, const Settings& settings,
                                      const FilterChoice& filter) {
  if (plugin.make) return plugin.make(settings);
  return std::make_unique<PatternSampler>(plugin.make_points(settings), filter, plugin.claims.deterministic);
}

}  // namespace moire
