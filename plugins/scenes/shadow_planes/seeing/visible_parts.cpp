#include "seeing/visible_parts.h"

#include "seeing/difference.h"

namespace shadow_planes {

VisibleParts::VisibleParts(const Bsp& bsp, const Camera& camera) {
  for (Part& part : image_parts(bsp, camera)) {
    const moire::Rectangle box = box_of(part.outline);
    parts_.push_back({std::move(part), box});
  }
}

void VisibleParts::in(const moire::Rectangle& window, std::vector<Part>& out) const {
  out.clear();
  const double least = 2e-14 * (window.x1 - window.x0) * (window.y1 - window.y0);
  // What no face so far covers.
  std::vector<Outline> open{
      {{window.x0, window.y0}, {window.x1, window.y0}, {window.x1, window.y1}, {window.x0, window.y1}}};
  std::vector<Outline> still_open;
  Outline within, beyond;
  for (const auto& [part, box] : parts_) {
    if (open.empty()) break;
    if (!touch(box, window)) continue;
    still_open.clear();
    for (Outline& piece : open) {
      if (!touch(box, box_of(piece)) || are_apart(part.outline, piece)) {
        still_open.push_back(std::move(piece));
        continue;
      }
      cut_out(piece, part.outline, least, still_open, within, beyond);
      if (doubled_area(piece) > least) out.push_back({part.face, piece});
    }
    std::swap(open, still_open);
  }
  for (Outline& piece : open) out.push_back({Part::none, std::move(piece)});
}

}  // namespace shadow_planes
