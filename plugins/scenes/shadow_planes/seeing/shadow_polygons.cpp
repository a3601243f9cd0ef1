#include "seeing/shadow_polygons.h"

#include <array>

#include "hard/clip_to.h"

namespace shadow_planes {

ShadowPolygons::ShadowPolygons(const World& world, const Bsp& bsp, const Camera& camera, const Occluders& occluders,
                               const Shading& shading, Clip clip) {
  const Homogeneous light = shading.light().at(0.5, 0.5);
  ShadowProjector project(clip);
  std::vector<moire::Pole> seen;
  ClipTo clip_to;
  for (const Part& part : image_parts(bsp, camera)) {
    const std::uint32_t face = part.face;
    const Receiver& receiver = shading.receiver(face);
    // Of equal colour all over, so any point tells it.
    const double irradiance = shading.irradiance(receiver.side, world.faces[face].parts[0][0], light);
    if (!(irradiance > 0)) {
      add(part.outline, unlit(face), shading.color(face, 0));
      continue;
    }
    for (const std::uint32_t by : receiver.occluders) {
      if (clip == Clip::both && occluders.is_edge_on(by, light)) continue;
      for (const Convex& occluder : occluders.parts(by)) {
        seen.clear();
        for (const Homogeneous& p : project(occluder, receiver.side, light)) seen.push_back(camera.image_of(p));
        add(clip_to(seen, part.outline), shadowed(face, by), shading.color(face, 0));
      }
    }
    add(part.outline, lit(face), shading.color(face, irradiance));
  }
}

void ShadowPolygons::add(const Outline& outline, moire::Element element, moire::Color color) {
  if (outline.size() < 3) return;
  entries_.push_back({element, color, points_.size(), outline.size(), box_of(outline)});
  points_.insert(points_.end(), outline.begin(), outline.end());
}

void ShadowPolygons::stream(const moire::Rectangle& window, moire::PolygonSink& sink) const {
  constexpr std::array<std::uint32_t, 1> one_contour{0};
  for (const Entry& entry : entries_) {
    if (!touch(entry.box, window)) continue;
    sink.polygon({entry.element, entry.color, moire::FillRule::nonzero,
                  std::span(points_).subspan(entry.begin, entry.count), one_contour});
  }
}

}  // namespace shadow_planes
