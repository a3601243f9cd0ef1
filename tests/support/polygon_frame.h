// A frame of given polygons.
#pragma once

#include <string>
#include <vector>

#include <moire/frame.h>

namespace moire::test {

struct FlatPolygon {
  Element element;
  Color color;
  FillRule rule;
  std::vector<std::vector<Point>> contours;
};

// Polygons from front to back. As artwork with an identity other than 0, they are seen through a placement.
class PolygonFrame final : public Frame, private Polygons, private Artwork {
 public:
  PolygonFrame(ImageSize size, std::vector<FlatPolygon> polygons, Color background = {}, std::uint64_t identity = 0,
               Affine placement = {})
      : size_(size),
        polygons_(std::move(polygons)),
        background_(background),
        identity_(identity),
        placement_(placement) {}

  ImageSize size() const override { return size_; }
  // The foremost polygon that winds around the point.
  void trace(std::span<const SamplePoint> points, std::span<Hit> hits, Counters& counters) const override;
  const Polygons* polygons() const override { return this; }

 private:
  bool disjoint() const override { return false; }
  void stream(const Rectangle& window, PolygonSink& sink) const override;
  Color background_color() const override { return background_; }
  const Artwork* artwork() const override { return identity_ == 0 ? nullptr : this; }

  std::uint64_t identity() const override { return identity_; }
  Affine placement() const override { return placement_; }
  void stream(PolygonSink& sink) const override { stream(sink, {}); }

  void stream(PolygonSink& sink, const Affine& map) const;

  ImageSize size_;
  std::vector<FlatPolygon> polygons_;
  Color background_;
  std::uint64_t identity_;
  Affine placement_;
};

}  // namespace moire::test
