#include "exact/layers.h"

namespace area {

Layers::Layers(const moire::Polygons& polygons, const moire::Rectangle& window) {
  polygons.stream(window, *this);
  layers_.push_back({moire::background, polygons.background_color(), moire::FillRule::nonzero});
}

Layers::Layers(const moire::Artwork& artwork, const moire::Affine& placement, moire::Color background) {
  artwork.stream(*this);
  map(placement);
  layers_.push_back({moire::background, background, moire::FillRule::nonzero});
}

void Layers::polygon(const moire::Polygon& polygon) {
  const auto layer = static_cast<std::uint32_t>(layers_.size());
  const auto base = static_cast<std::uint32_t>(points_.size());
  points_.insert(points_.end(), polygon.points.begin(), polygon.points.end());
  for (std::size_t k = 0; k < polygon.contours.size(); ++k) {
    const std::uint32_t first = base + polygon.contours[k];
    const std::uint32_t end =
        k + 1 < polygon.contours.size() ? base + polygon.contours[k + 1] : static_cast<std::uint32_t>(points_.size());
    if (end - first >= 3) contours_.push_back({layer, first, end});
  }
  layers_.push_back({polygon.element, polygon.color, polygon.rule});
}

}  // namespace area
