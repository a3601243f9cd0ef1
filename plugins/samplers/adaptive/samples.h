// Points that were looked at once, and count in as many pixels as need them.
#pragma once

#include <span>
#include <vector>

#include <moire/probe.h>

#include "criterion.h"

namespace adaptive {

class Samples {
 public:
  // Requires: `request` outlives this.
  Samples(const moire::RenderRequest& request, bool recording) : request_(request), recording_(recording) {}

  // Forgets all of them.
  void clear() {
    rounds_.clear();
    seen_.clear();
  }

  // Looks at points and numbers them on from the last ones; ends[k] is behind the last point of batch k. `spacing`:
  // of the points, what lookups filter over. Counts the work. Under an area light each is given a point of it, which
  // depends on its place: pixels that share a corner see the same there.
  void look_at(std::span<moire::SamplePoint> points, std::span<const std::size_t> ends, moire::Spacing spacing,
               moire::Counters& counters);

  std::size_t count() const { return seen_.size(); }
  const Sample& operator[](std::size_t k) const { return seen_[k]; }

  // Adds what was seen at a point to a pixel.
  void add_to(moire::PixelBlock& block, std::size_t slot, std::size_t k, double weight) const;

 private:
  struct Round {
    std::size_t first;
    moire::Tally tally;
  };

  const moire::RenderRequest& request_;
  bool recording_;
  std::vector<Round> rounds_;
  std::vector<Sample> seen_;
};

}  // namespace adaptive
