// The polygons of a stream as plain arrays: layers from front to back, their contours, and the background behind all.
#pragma once

#include <cstdint>
#include <vector>

#include <moire/frame.h>

namespace area {

// One polygon of an ordered stream.
struct Layer {
  moire::Element element;
  moire::Color color;
  moire::FillRule rule;

  bool is_inside(int winding) const { return rule == moire::FillRule::nonzero ? winding != 0 : (winding & 1) != 0; }
};

// Layer 0 is the front; the last one is the background, which has no contours and is everywhere.
class Layers final : private moire::PolygonSink {
 public:
  // All polygons that touch the window, in image coordinates.
  Layers(const moire::Polygons& polygons, const moire::Rectangle& window);
  // All polygons of an artwork, mapped.
  Layers(const moire::Artwork& artwork, const moire::Affine& placement, moire::Color background);

  struct Contour {
    std::uint32_t layer;
    std::uint32_t first, end;  // points, closed implicitly; at least three
  };

  // Moves all points.
  void map(const moire::Affine& map) {
    for (moire::Point& point : points_) point = map(point);
  }

  std::uint32_t background() const { return static_cast<std::uint32_t>(layers_.size() - 1); }
  const Layer& operator[](std::uint32_t layer) const { return layers_[layer]; }
  std::size_t size() const { return layers_.size(); }
  const std::vector<Contour>& contours() const { return contours_; }
  const moire::Point* points() const { return points_.data(); }
  std::size_t point_count() const { return points_.size(); }

 private:
  void polygon(const moire::Polygon& polygon) override;

  std::vector<Layer> layers_;
  std::vector<Contour> contours_;
  std::vector<moire::Point> points_;
};

}  // namespace area
