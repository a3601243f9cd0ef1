// What the frames of all kinds share: points one by one, and averages pixel by pixel.
#pragma once

#include <moire/frame.h>

#include "look.h"

namespace pattern {

// `Kind` has `Hit at(Point) const`, or its own see(), and overrides integrate().
template <class Kind>
class PatternFrame : public moire::Frame, protected moire::Averages {
 public:
  explicit PatternFrame(const Look& look) : look_(look) {}

  moire::ImageSize size() const override { return look_.size; }
  const moire::Averages* averages() const override { return this; }
  void trace(std::span<const moire::SamplePoint> points, std::span<moire::Hit> hits,
             moire::Counters& counters) const override {
    static_cast<const Kind&>(*this).see(points, hits);
    counters.queries += points.size();
    for (const moire::Hit& hit : hits) counters.hits += hit.element != moire::background ? 1 : 0;
  }
  void see(std::span<const moire::SamplePoint> points, std::span<moire::Hit> hits) const {
    for (std::size_t k = 0; k < points.size(); ++k)
      hits[k] = static_cast<const Kind&>(*this).at({points[k].x, points[k].y});
  }

 protected:
  const Look& look() const { return look_; }

  // Calls content(x, y, deposit) for every pixel of the block, which calls deposit(element, weight, color).
  template <class Content>
  static void fill(moire::PixelBlock& block, Content content) {
    std::uint64_t hits = 0;
    block.fill([&](auto add) {
      for (int x = block.x0; x < block.x0 + block.width; ++x) {
        for (int y = block.y0; y < block.y0 + block.height; ++y) {
          const std::size_t slot = block.slot(x, y);
          bool is_hit = false;
          content(x, y, [&](moire::Element element, double weight, moire::Color color) {
            if (weight == 0) return;
            add(slot, element, weight, color);
            is_hit |= element != moire::background;
          });
          hits += is_hit ? 1 : 0;
        }
      }
    });
    block.counters.queries += block.slots();
    block.counters.hits += hits;
  }

 private:
  Look look_;
};

}  // namespace pattern
