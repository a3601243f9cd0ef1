#include "light/casters.h"

#include <algorithm>
#include <limits>

#include "world/cut.h"

namespace shadow_planes {

namespace {

constexpr double in_plane = 1e-12;

double size_of(Vector p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}); }

// How far a point lies from the plane; 0 if only rounding says that it does not lie in it.
double settled_distance(const Plane& plane, Vector p) {
  const double distance = plane.distance(p);
  return std::abs(distance) <= in_plane * (size_of(p) + std::abs(plane.d)) ? 0 : distance;
}

// Corners that follow a corner at the same place bound nothing.
Convex without_repeats(const Convex& polygon) {
  Convex out;
  for (const Vector& p : polygon) {
    if (out.empty() || !(out.back() == p)) out.push_back(p);
  }
  while (out.size() > 1 && out.back() == out.front()) out.pop_back();
  return out;
}

bool has_area(const Convex& polygon) {
  if (polygon.size() < 3) return false;
  Vector sum;
  double longest = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Vector a = polygon[i] - polygon[0], b = polygon[i + 1] - polygon[0];
    sum = sum + cross(a, b);
    longest = std::max({longest, dot(a, a), dot(b, b)});
  }
  return length(sum) > 1e-15 * longest;
}

// Upright to the axes; empty at first.
class Box {
 public:
  void add(Vector p) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y), std::max(high_.z, p.z)};
  }
  void add(const std::vector<Convex>& parts) {
    for (const Convex& part : parts) add(part);
  }
  void add(const Convex& part) {
    for (const Vector& p : part) add(p);
  }
  bool touches(const Box& other) const {
    return low_.x <= other.high_.x && other.low_.x <= high_.x && low_.y <= other.high_.y && other.low_.y <= high_.y &&
           low_.z <= other.high_.z && other.low_.z <= high_.z;
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Vector low_{infinity, infinity, infinity}, high_{-infinity, -infinity, -infinity};
};

}  // namespace

Convex clipped(const Convex& polygon, const Plane& plane) {
  Convex out;
  keep(
      polygon, [&](const Vector& p) { return settled_distance(plane, p); }, out);
  out = without_repeats(out);
  if (out.size() < 3) out.clear();
  return out;
}

std::vector<Caster> casters_on(const World& world, std::uint32_t receiver, const Plane& side) {
  std::vector<Caster> casters;
  if (!world.faces[receiver].receives) return casters;
  const Light& light = world.light;
  // Between the receiver and the light nothing is outside a box around both.
  Box between;
  between.add(world.faces[receiver].parts);
  between.add(light.parts);
  if (light.kind == LightKind::point) between.add(light.place);
  for (std::uint32_t face = 0; face < world.faces.size(); ++face) {
    if (face == receiver || !world.faces[face].casts) continue;
    for (const Convex& part : world.faces[face].parts) {
      Box box;
      box.add(part);
      if (light.kind != LightKind::directional && !box.touches(between)) continue;
      Convex corners = clipped(part, side);
      if (light.kind == LightKind::area) corners = clipped(corners, light.plane);
      if (light.kind == LightKind::point) {
        corners = clipped(corners, {-side.normal, side.distance(light.place) - side.d});
      }
      const bool stands_out =
          std::any_of(corners.begin(), corners.end(), [&](const Vector& p) { return settled_distance(side, p) > 0; });
      if (stands_out && has_area(corners)) casters.push_back({face, world.faces[face].plane, std::move(corners)});
    }
  }
  return casters;
}

}  // namespace shadow_planes
