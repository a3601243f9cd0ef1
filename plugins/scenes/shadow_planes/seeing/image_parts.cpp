#include "seeing/image_parts.h"

#include <algorithm>
#include <array>

#include "world/cut.h"

namespace shadow_planes {

std::vector<Part> image_parts(const Bsp& bsp, const Camera& camera) {
  const double width = camera.size.width, height = camera.size.height;
  constexpr double margin = 64;
  // What is behind the eye is on the wrong side of one of these.
  const std::array<Line, 4> sides{Line{1, 0, width + margin}, Line{-1, 0, 2 * width + margin},
                                  Line{0, 1, height + margin}, Line{0, -1, 2 * height + margin}};
  std::vector<Part> parts;
  std::vector<moire::Pole> polygon, cut;
  for (const Bsp::Fragment* fragment : bsp.front_to_back(camera.eye)) {
    polygon.clear();
    for (const Vector& p : fragment->outline) polygon.push_back(camera.image_of({p.x, p.y, p.z, 1}));
    for (const Line& side : sides) {
      keep(polygon, side, cut);
      std::swap(polygon, cut);
    }
    Part part{fragment->face, {}};
    for (const moire::Pole& p : polygon) {
      if (p.w > 0) part.outline.push_back({p.x / p.w, p.y / p.w});
    }
    if (part.outline.size() < 3) continue;
    const double area = doubled_area(part.outline);
    if (area == 0) continue;
    if (area < 0) std::reverse(part.outline.begin(), part.outline.end());
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace shadow_planes
