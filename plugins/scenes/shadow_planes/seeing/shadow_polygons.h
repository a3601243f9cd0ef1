// The picture as polygons front to back, where every face has one colour where it is lit and one where it is not.
#pragma once

#include <vector>

#include <moire/frame.h>

#include "seeing/image_parts.h"
#include "seeing/shading.h"

namespace shadow_planes {

// Before each visible fragment of a face come the shadows on it, by the occluders' places in the list.
class ShadowPolygons {
 public:
  // Requires: a light that is no area, and is directional or Shade::flat.
  ShadowPolygons(const World& world, const Bsp& bsp, const Camera& camera, const Occluders& occluders,
                 const Shading& shading, Clip clip);

  void stream(const moire::Rectangle& window, moire::PolygonSink& sink) const;

 private:
  void add(const Outline& outline, moire::Element element, moire::Color color);

  struct Entry {
    moire::Element element;
    moire::Color color;
    std::size_t begin, count;  // of points_
    moire::Rectangle box;
  };
  std::vector<moire::Point> points_;
  std::vector<Entry> entries_;
};

}  // namespace shadow_planes
