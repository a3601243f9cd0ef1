// The nearest face through points of the image.
#pragma once

#include <span>
#include <vector>

#include <moire/geometry.h>

#include "seeing/camera.h"
#include "seeing/outline.h"
#include "world/world.h"

namespace shadow_planes {

class FirstFaces {
 public:
  FirstFaces(const World& world, const Camera& camera);

  // Calls visit(index, face, point) for each point of the image in turn: the face seen there, of several at one depth
  // the first of the list, and where on it; or miss(index).
  template <class ImagePoint, class Visit, class Miss>
  void look(std::span<const ImagePoint> points, Visit visit, Miss miss) const {
    if (points.empty()) return;
    moire::Rectangle around{points[0].x, points[0].y, points[0].x, points[0].y};
    for (const ImagePoint& p : points) {
      around.x0 = std::min(around.x0, p.x), around.x1 = std::max(around.x1, p.x);
      around.y0 = std::min(around.y0, p.y), around.y1 = std::max(around.y1, p.y);
    }
    std::vector<const Cone*> near;
    for (const Cone& cone : cones_) {
      if (touch(cone.box, around)) near.push_back(&cone);
    }
    for (std::size_t k = 0; k < points.size(); ++k) {
      const moire::Point p{points[k].x, points[k].y};
      double largest = 0;  // of 1 / depth
      const Cone* first = nullptr;
      for (const Cone* cone : near) {
        if (!cone->holds(p)) continue;
        const double nearness = cone->nearness(p);
        if (nearness > largest) largest = nearness, first = cone;
      }
      if (first) {
        visit(k, first->face, camera_.eye + (1 / largest) * camera_.ray(p));
      } else {
        miss(k);
      }
    }
  }

 private:
  // A convex part as the eye sees it.
  struct Cone {
    std::uint32_t face;
    moire::Rectangle box;     // of the image, around it
    Line nearness;            // 1 / depth
    std::vector<Line> edges;  // not negative within

    bool holds(const moire::Point& p) const {
      if (p.x < box.x0 || p.x > box.x1 || p.y < box.y0 || p.y > box.y1) return false;
      return std::all_of(edges.begin(), edges.end(), [&](const Line& edge) { return edge(p) >= 0; });
    }
  };

  Camera camera_;
  std::vector<Cone> cones_;
};

}  // namespace shadow_planes
