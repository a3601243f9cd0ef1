#include "hard/occluders.h"

#include <algorithm>
#include <tuple>

namespace shadow_planes {

namespace {

double largest_coordinate(const World& world) {
  double largest = 0;
  const auto take = [&](const Vector& p) {
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  };
  for (const Face& face : world.faces) {
    for (const Convex& part : face.parts) std::for_each(part.begin(), part.end(), take);
  }
  for (const Convex& part : world.light.parts) std::for_each(part.begin(), part.end(), take);
  if (world.light.kind == LightKind::point) take(world.light.place);
  return largest;
}

// Through an edge, at right angles to its polygon's plane. The two parts beside an edge get planes that differ in sign
// alone, so that no point falls between them.
Plane edge_plane(const Vector& normal, const Vector& a, const Vector& b) {
  const bool is_reversed = std::tie(b.x, b.y, b.z) < std::tie(a.x, a.y, a.z);
  const Vector &first = is_reversed ? b : a, &last = is_reversed ? a : b;
  const Vector across = cross(normal, last - first);
  const double d = -dot(across, first);
  return is_reversed ? Plane{-across, -d} : Plane{across, d};
}

}  // namespace

Occluders::Occluders(const World& world, Clip clip) : world_(world), clip_(clip) {
  const double scale = largest_coordinate(world);
  tolerance_ = 1e-12 * scale;
  const Plane& light = world.light.plane;
  for (const Face& face : world.faces) {
    Obstacle& obstacle = obstacles_.emplace_back();
    if (!face.casts) continue;
    obstacle.plane = face.plane;
    obstacle.parts = face.parts;
    const auto is_in_lights_plane = [&](const Convex& part) {
      return std::all_of(part.begin(), part.end(),
                         [&](const Vector& p) { return std::abs(light.distance(p)) <= tolerance_; });
    };
    if (world.light.kind == LightKind::area && !world.light.parts.empty() &&
        std::all_of(face.parts.begin(), face.parts.end(), is_in_lights_plane)) {
      const Vector by = (1e-9 * scale) * light.normal;
      obstacle.plane.d -= dot(obstacle.plane.normal, by);
      for (Convex& part : obstacle.parts) {
        for (Vector& p : part) p = p + by;
      }
    }
    for (const Convex& part : obstacle.parts) {
      std::vector<Plane>& sides = obstacle.sides.emplace_back();
      for (std::size_t k = 0; k < part.size(); ++k)
        sides.push_back(edge_plane(obstacle.plane.normal, part[k], part[(k + 1) % part.size()]));
    }
  }
}

Receiver Occluders::receiver(std::uint32_t face, Vector eye) const {
  Receiver result{world_.faces[face].plane, {}};
  if (result.side.distance(eye) < 0) result.side = {-result.side.normal, -result.side.d};
  if (!world_.faces[face].receives) return result;
  for (std::uint32_t by = 0; by < obstacles_.size(); ++by) {
    const std::vector<Convex>& parts = obstacles_[by].parts;
    const bool is_before = std::any_of(parts.begin(), parts.end(), [&](const Convex& part) {
      return std::any_of(part.begin(), part.end(),
                         [&](const Vector& p) { return result.side.distance(p) > tolerance_; });
    });
    if (by != face && !parts.empty() && (is_before || clip_ == Clip::none)) result.occluders.push_back(by);
  }
  return result;
}

bool Occluders::hides(std::uint32_t face, const Plane& receiver, const Vector& point, const Homogeneous& light) const {
  const Obstacle& obstacle = obstacles_[face];
  if (clip_ == Clip::none) return is_in_published_shadow(obstacle, receiver, point, light);
  const double here = obstacle.plane.distance(point);
  if (std::abs(here) <= tolerance_ || is_edge_on(face, light)) return false;
  const double there = obstacle.plane.of(light);
  if ((here > 0) == (there > 0)) return false;
  const Vector way = Vector{light.x, light.y, light.z} - light.w * point;
  const Vector crossing = point + (here / (light.w * here - there)) * way;
  return std::any_of(obstacle.sides.begin(), obstacle.sides.end(), [&](const std::vector<Plane>& sides) {
    return std::all_of(sides.begin(), sides.end(), [&](const Plane& side) { return side.distance(crossing) >= 0; });
  });
}

bool Occluders::is_in_published_shadow(const Obstacle& obstacle, const Plane& receiver, const Vector& point,
                                       const Homogeneous& light) const {
  ShadowProjector project(Clip::none);
  for (const Convex& part : obstacle.parts) {
    const std::vector<Homogeneous>& shadow = project(part, receiver, light);
    // Crossings of a ray of the plane, by their direction: the winding number.
    int winding = 0;
    const Vector normal = receiver.normal;
    const Vector aside = std::abs(normal.x) < 0.5 ? Vector{1, 0, 0} : Vector{0, 1, 0};
    const Vector u = cross(normal, aside), v = cross(normal, u);
    for (std::size_t k = 0; k < shadow.size(); ++k) {
      const Homogeneous &a = shadow[k], &b = shadow[(k + 1) % shadow.size()];
      const Vector p = Vector{a.x, a.y, a.z} - point, q = Vector{b.x, b.y, b.z} - point;
      const double px = dot(u, p), py = dot(v, p), qx = dot(u, q), qy = dot(v, q);
      if ((py > 0) == (qy > 0)) continue;
      if ((px * qy - qx * py > 0) == (qy > py)) winding += qy > py ? 1 : -1;
    }
    if (winding != 0) return true;
  }
  return false;
}

}  // namespace shadow_planes
