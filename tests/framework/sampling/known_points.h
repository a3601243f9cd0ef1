// A frame on which every point is an element of its own, so that fragments say where a pixel's weights lie.
#pragma once

#include <moire/frame.h>

namespace moire::test {

class KnownPoints final : public Frame {
 public:
  explicit KnownPoints(ImageSize size) : size_(size) {}

  ImageSize size() const override { return size_; }
  // On one thread only.
  void trace(std::span<const SamplePoint> points, std::span<Hit> hits, Counters& counters) const override {
    counters.queries += points.size();
    for (std::size_t k = 0; k < points.size(); ++k) {
      points_.push_back({points[k].x, points[k].y});
      hits[k] = {points_.size(), {0.5F, 0.5F, 0.5F}};
    }
  }

  Point point(Element element) const { return points_[element - 1]; }

 private:
  ImageSize size_;
  mutable std::vector<Point> points_;
};

// Calls visit(weight, point) for each point that counts in a pixel.
template <class Visit>
void for_each_point(const PixelBlock& block, const KnownPoints& frame, int x, int y, Visit visit) {
  block.for_each(block.slot(x, y), [&](const Fragment& f) { visit(f.weight, frame.point(f.element)); });
}

}  // namespace moire::test
