#include "exact/visible_voxels.h"

#include <algorithm>
#include <cmath>

#include "exact/sweep.h"

namespace heightfield {

namespace {

using exact::Projection;
using exact::Wedge;

// Wedges are about so wide. Narrower ones cut more voxels in two, wider ones let narrow windows wait for more of the
// picture beside them.
constexpr double pixels_per_wedge = 8;

// Where a window ends, in pixels: what touches a pixel by rounding errors alone is streamed for all windows with it.
constexpr double window_margin = 1e-6;

moire::Rectangle widened(const moire::Rectangle& r) {
  return {r.x0 - window_margin, r.y0 - window_margin, r.x1 + window_margin, r.y1 + window_margin};
}

// One of the eight octants, as far as the picture shows it.
struct Octant {
  Plane axes;
  Projection projection;
  Wedge wedge;
};

std::vector<Octant> octants_of(const Look& look) {
  const moire::Rectangle picture = widened({0, 0, double(look.size().width), double(look.size().height)});
  std::vector<Octant> octants;
  for (const bool swapped : {false, true}) {
    for (const bool flip_p : {false, true}) {
      for (const bool flip_q : {false, true}) {
        const Plane axes{swapped, flip_p, flip_q, 0};
        const Projection projection(look.size(), look.camera(), axes);
        const auto part = projection.part_of(picture, {0, 1});
        if (part.empty()) continue;
        const Wedge wedge = projection.wedge_of(part);
        if (wedge.u0 < wedge.u1) octants.push_back({axes, projection, wedge});
      }
    }
  }
  return octants;
}

}  // namespace

void VisibleVoxels::stream(const moire::Rectangle& window, moire::PolygonSink& sink) const { visit(window, sink); }

std::uint64_t VisibleVoxels::visit(const moire::Rectangle& window, moire::PolygonSink& sink) const {
  const moire::ImageSize size = look_.size();
  const moire::Rectangle picture = widened({0, 0, double(size.width), double(size.height)});
  const moire::Rectangle seen = widened(window);
  const std::vector<Octant> octants = octants_of(look_);
  double all = 0;
  for (const Octant& octant : octants) all += octant.wedge.u1 - octant.wedge.u0;

  std::uint64_t visited = 0;
  for (const Octant& octant : octants) {
    const auto& [u0, u1] = octant.wedge;
    const int wedges = static_cast<int>(std::ceil(size.width / pixels_per_wedge * (u1 - u0) / all));
    const auto bound = [&](int k) { return k == wedges ? u1 : u0 + k * (u1 - u0) / wedges; };
    for (int k = 0; k < wedges; ++k) {
      const Wedge wedge{bound(k), bound(k + 1)};
      const auto wanted = octant.projection.part_of(seen, wedge), part = octant.projection.part_of(picture, wedge);
      if (wanted.empty() || part.empty()) continue;
      const auto window_rises = octant.projection.rises_of(wanted);
      const exact::Range range{octant.projection.rises_of(part).lowest, window_rises.lowest, window_rises.highest,
                               part};
      visited += exact::sweep(look_.view(), octant.axes, octant.projection, wedge, range, sink);
    }
  }
  return visited;
}

}  // namespace heightfield
