// Looking at points of a frame, through the lookup if there is one.
#pragma once

#include <vector>

#include <moire/sampler.h>

namespace moire {

// Deposits what is seen at points. Keeps its buffers; one a thread.
class Probe {
 public:
  // `spacing`: of the points, what a lookup filters over. Requires: `request` outlives the probe.
  Probe(const RenderRequest& request, Spacing spacing) : request_(request) {
    if (request.lookup && request.lookup->footprint() == Footprint::sample) spacing_ = spacing;
  }

  // Deposits what is seen at points[k] into slot(k) with weight(k); counts the work in tally.counters.
  template <class Slot, class Weight>
  void see(std::span<const SamplePoint> points, Tally& tally, Slot slot, Weight weight) {
    request_.lookup ? look_up(points, tally, slot, weight) : trace(points, tally, slot, weight);
  }

  // What lies at the k-th of the points last seen, whatever texels a lookup made of it.
  Element element(std::size_t k) const { return request_.lookup ? places_[k].hit.element : hits_[k].element; }

 private:
  template <class Slot, class Weight>
  void trace(std::span<const SamplePoint> points, Tally& tally, Slot slot, Weight weight) {
    hits_.resize(points.size());
    request_.frame.trace(points, hits_, tally.counters);
    tally.fill([&](auto add) {
      for (std::size_t k = 0; k < hits_.size(); ++k) add(slot(k), hits_[k].element, weight(k), hits_[k].color);
    });
  }

  template <class Slot, class Weight>
  void look_up(std::span<const SamplePoint> points, Tally& tally, Slot slot, Weight weight) {
    const Surface& surface = *request_.frame.surface();
    const auto across = static_cast<float>(spacing_.x), down = static_cast<float>(spacing_.y);
    places_.resize(points.size());
    surface.locate(points, places_, tally.counters);
    for (std::size_t k = 0; k < places_.size(); ++k) {
      SurfacePoint& place = places_[k];
      if (!place.textured) {
        tally.add(slot(k), place.hit.element, weight(k), place.hit.color);
        continue;
      }
      place.ds_dx *= across;
      place.dt_dx *= across;
      place.ds_dy *= down;
      place.dt_dy *= down;
      request_.lookup->deposit(place, surface.texture(), weight(k), tally, slot(k));
    }
  }

  const RenderRequest& request_;
  Spacing spacing_;
  std::vector<Hit> hits_;
  std::vector<SurfacePoint> places_;
};

}  // namespace moire
