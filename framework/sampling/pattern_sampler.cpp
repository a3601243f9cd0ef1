#include "sampling/pattern_sampler.h"

#include <optional>

#include "sampling/strands.h"

namespace moire {

namespace {

class PatternRendering final : public Rendering {
 public:
  PatternRendering(const PointSampler& sampler, const RenderRequest& request) : sampler_(sampler), request_(request) {}

  void render(PixelBlock& block) const override {
    std::optional<Strands> strands;
    std::vector<Hit> hits;
    std::vector<SurfacePoint> places;
    for (int x = block.x0; x < block.x0 + block.width; ++x) {
      if (strands && sampler_.same_in_every_pixel()) {
        strands->move_to(x);
      } else {
        strands.emplace(sampler_, Pixel{x, 0, request_.frame_number, request_.seed}, block.y0, block.height);
      }
      const std::size_t base = block.slot(x, block.y0);
      for (const Strand& strand : strands->all()) {
        if (request_.lookup) {
          look_up(strand, base, places, block);
        } else {
          trace(strand, base, hits, block);
        }
      }
    }
  }

 private:
  void trace(const Strand& strand, std::size_t base, std::vector<Hit>& hits, PixelBlock& block) const {
    hits.resize(strand.points.size());
    request_.frame.trace(strand.points, hits, block.counters);
    block.fill([&](auto add) {
      for (std::size_t k = 0; k < hits.size(); ++k) {
        add(base + strand.rows[k], hits[k].element, strand.weights[k], hits[k].color);
      }
    });
  }

  void look_up(const Strand& strand, std::size_t base, std::vector<SurfacePoint>& places, PixelBlock& block) const {
    const Surface& surface = *request_.frame.surface();
    places.resize(strand.points.size());
    surface.locate(strand.points, places, block.counters);
    for (std::size_t k = 0; k < places.size(); ++k) {
      const std::size_t slot = base + strand.rows[k];
      if (places[k].textured) {
        request_.lookup->deposit(places[k], surface.texture(), strand.weights[k], block, slot);
      } else {
        block.add(slot, places[k].hit.element, strand.weights[k], places[k].hit.color);
      }
    }
  }

  const PointSampler& sampler_;
  RenderRequest request_;
};

class PatternSampler final : public Sampler {
 public:
  explicit PatternSampler(std::unique_ptr<PointSampler> points) : points_(std::move(points)) {}
  std::unique_ptr<Rendering> begin(const RenderRequest& request) const override {
    return std::make_unique<PatternRendering>(*points_, request);
  }

 private:
  std::unique_ptr<PointSampler> points_;
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(const SamplerPlugin& plugin, const Settings& settings) {
  if (plugin.make) return plugin.make(settings);
  return std::make_unique<PatternSampler>(plugin.make_points(settings));
}

}  // namespace moire
