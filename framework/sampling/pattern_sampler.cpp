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
  PatternRendering(const PointSampler& sampler, const RenderRequest& request)
      : sampler_(sampler), request_(request), spacing_(spacing_of(sampler, request)) {}

  void render(PixelBlock& block) const override {
    std::optional<Strands> strands;
    Probe probe(request_, spacing_);
    for (int x = block.x0; x < block.x0 + block.width; ++x) {
      if (strands && sampler_.same_in_every_pixel()) {
        strands->move_to(x);
      } else {
        strands.emplace(sampler_, Pixel{x, 0, request_.frame_number, request_.seed}, block.y0, block.height);
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
  Spacing spacing_;
};

class PatternSampler final : public Sampler {
 public:
  PatternSampler(std::unique_ptr<PointSampler> points, const FilterChoice& filter)
      : points_(std::move(points)), filter_(filter) {}
  std::unique_ptr<Rendering> begin(const RenderRequest& request) const override {
    if (filter_.name == filters().front().name) return std::make_unique<PatternRendering>(*points_, request);
    return std::make_unique<FilteredRendering>(*points_, request, filter_);
  }

 private:
  std::unique_ptr<PointSampler> points_;
  FilterChoice filter_;
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(const SamplerPlugin& plugin, const Settings& settings,
                                      const FilterChoice& filter) {
  if (plugin.make) return plugin.make(settings);
  return std::make_unique<PatternSampler>(plugin.make_points(settings), filter);
}

}  // namespace moire
