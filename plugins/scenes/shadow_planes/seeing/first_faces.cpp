#include "seeing/first_faces.h"

#include <limits>
#include <tuple>

namespace shadow_planes {

namespace {

// dot(v, camera.ray(p)), linear in p.
Line along_rays(const Vector& v, const Camera& camera) {
  const double a = dot(v, camera.right) / camera.focal, b = dot(v, camera.down) / camera.focal;
  return {a, b, dot(v, camera.ahead) - 0.5 * camera.size.width * a - 0.5 * camera.size.height * b};
}

// The plane through the eye and an edge; of a reversed edge, its negative to the bit.
Vector edge_normal(const Vector& eye, const Vector& a, const Vector& b) {
  const bool is_reversed = std::tie(b.x, b.y, b.z) < std::tie(a.x, a.y, a.z);
  return is_reversed ? -cross(b - eye, a - eye) : cross(a - eye, b - eye);
}

// Around a part of the image; without bounds if some of it is behind the eye. Wider than that by what rounding may do.
moire::Rectangle box_around(const Convex& part, const Camera& camera) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Outline corners;
  for (const Vector& p : part) {
    const moire::Pole seen = camera.image_of({p.x, p.y, p.z, 1});
    if (!(seen.w > 0)) return {-infinity, -infinity, infinity, infinity};
    corners.push_back({seen.x / seen.w, seen.y / seen.w});
  }
  const moire::Rectangle box = box_of(corners);
  constexpr double rounding = 1e-6;
  return {box.x0 - rounding, box.y0 - rounding, box.x1 + rounding, box.y1 + rounding};
}

}  // namespace

FirstFaces::FirstFaces(const World& world, const Camera& camera) : camera_(camera) {
  for (std::uint32_t k = 0; k < world.faces.size(); ++k) {
    const Face& face = world.faces[k];
    if (!face.shown) continue;
    const double height = face.plane.distance(camera.eye);
    if (height == 0) continue;  // edge-on
    for (const Convex& part : face.parts) {
      Cone cone{k, box_around(part, camera), along_rays((-1 / height) * face.plane.normal, camera), {}};
      for (std::size_t i = 0; i < part.size(); ++i) {
        const Vector normal = edge_normal(camera.eye, part[i], part[(i + 1) % part.size()]);
        // Seen from behind, corners go round the other way.
        cone.edges.push_back(along_rays(height > 0 ? -normal : normal, camera));
      }
      cones_.push_back(std::move(cone));
    }
  }
}

}  // namespace shadow_planes
