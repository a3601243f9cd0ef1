#include "seeing/visible_parts.h"

#include <algorithm>

#include "world/cut.h"

namespace shadow_planes {

namespace {

// Whether an edge of one lies between it and all of the other.
bool are_apart(const Outline& part, const Outline& piece) {
  const moire::Point* from = &part.back();
  for (const moire::Point& to : part) {
    const Line edge = edge_line(*from, to);
    if (std::none_of(piece.begin(), piece.end(), [&](const moire::Point& p) { return edge(p) > 0; })) return true;
    from = &to;
  }
  return false;
}

}  // namespace

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
      // Edge by edge, what lies beyond it stays open, the rest is in question.
      const moire::Point* from = &part.outline.back();
      for (const moire::Point& to : part.outline) {
        split(piece, edge_line(*from, to), within, beyond);
        from = &to;
        if (doubled_area(beyond) > least) still_open.push_back(beyond);
        std::swap(piece, within);
        if (doubled_area(piece) <= least) break;
      }
      if (doubled_area(piece) > least) out.push_back({part.face, piece});
    }
    std::swap(open, still_open);
  }
  for (Outline& piece : open) out.push_back({Part::none, std::move(piece)});
}

}  // namespace shadow_planes
