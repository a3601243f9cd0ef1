#include "plugins/shadow_planes/brute_force.h"

#include <cmath>
#include <numbers>

namespace moire::test {

using shadow_planes::Convex;
using shadow_planes::Homogeneous;
using shadow_planes::LightKind;
using shadow_planes::Vector;

namespace {

struct Long {
  long double x, y, z;
};
Long wide(const Vector& p) { return {p.x, p.y, p.z}; }
Long minus(const Long& p, const Long& q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }
Long times(const Long& p, const Long& q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}
long double dot(const Long& p, const Long& q) { return p.x * q.x + p.y * q.y + p.z * q.z; }

}  // namespace

std::optional<long double> ray_meets(const Vector& from, const Vector& way, const Vector& a, const Vector& b,
                                     const Vector& c) {
  const Long one = minus(wide(b), wide(a)), two = minus(wide(c), wide(a)), d = wide(way);
  const Long p = times(d, two);
  const long double volume = dot(one, p);
  if (volume == 0) return {};
  const Long t = minus(wide(from), wide(a));
  const long double u = dot(t, p) / volume;
  const Long q = times(t, one);
  const long double v = dot(d, q) / volume;
  if (u < 0 || v < 0 || u + v > 1) return {};
  return dot(two, q) / volume;
}

bool stands_between(const Convex& part, const Vector& point, const Homogeneous& light) {
  const Vector way = Vector{light.x, light.y, light.z} - light.w * point;
  for (std::size_t k = 2; k < part.size(); ++k) {
    const auto met = ray_meets(point, way, part[0], part[k - 1], part[k]);
    if (met && *met > 1e-13L && (light.w == 0 || *met < 1 - 1e-13L)) return true;
  }
  return false;
}

std::optional<FaceMet> first_face(const shadow_planes::World& world, const shadow_planes::Camera& camera, Point p) {
  std::optional<FaceMet> first;
  long double nearest = std::numeric_limits<long double>::infinity();
  const Vector way = camera.ray(p);
  for (std::uint32_t k = 0; k < world.faces.size(); ++k) {
    for (const Convex& part : world.faces[k].parts) {
      for (std::size_t i = 2; i < part.size(); ++i) {
        const auto met = ray_meets(camera.eye, way, part[0], part[i - 1], part[i]);
        // Of those in one plane, the first of the list.
        if (!met || *met <= 0 || *met >= nearest * (1 - 1e-12L)) continue;
        nearest = *met;
        first = FaceMet{k, camera.eye + static_cast<double>(*met) * way};
      }
    }
  }
  return first;
}

Hit seen(const shadow_planes::World& world, const shadow_planes::Camera& camera, shadow_planes::Shade shade,
         const Homogeneous& light, Point p) {
  const auto first = first_face(world, camera, p);
  if (!first) return {background, world.sky};
  const shadow_planes::Face& face = world.faces[first->face];
  const auto is_flat = shade == shadow_planes::Shade::flat;
  const auto reflected = [&](double share) {
    const Color& sent = is_flat ? world.light.flat : world.light.color;
    const auto channel = [&](float reflectance, float ambient, float of_light) {
      return static_cast<float>(static_cast<double>(reflectance) *
                                (static_cast<double>(ambient) + share * static_cast<double>(of_light)));
    };
    return Color{channel(face.reflectance.r, world.ambient.r, sent.r),
                 channel(face.reflectance.g, world.ambient.g, sent.g),
                 channel(face.reflectance.b, world.ambient.b, sent.b)};
  };
  // Cosines at the surface, whose seen side is the eye's, and at the light.
  const Vector normal = face.plane.distance(camera.eye) > 0 ? face.plane.normal : Vector{} - face.plane.normal;
  const Vector way = Vector{light.x, light.y, light.z} - light.w * first->point;
  const double far = length(way), cosine = dot(normal, way) / far;
  double share = cosine;
  if (light.w > 0) share /= far * far;
  if (world.light.kind == LightKind::area) {
    double area = 0;
    for (const Convex& part : world.light.parts) {
      for (std::size_t k = 2; k < part.size(); ++k) area += length(cross(part[k - 1] - part[0], part[k] - part[0])) / 2;
    }
    share *= area * std::max(0.0, 0 - dot(world.light.plane.normal, way) / far);
  }
  if (!(share > 1e-13 && cosine > 1e-13)) return {shadow_planes::unlit(first->face), reflected(0)};
  if (face.receives) {
    for (std::uint32_t by = 0; by < world.faces.size(); ++by) {
      if (by == first->face || !world.faces[by].casts) continue;
      for (const Convex& part : world.faces[by].parts) {
        if (stands_between(part, first->point, light)) return {shadow_planes::shadowed(first->face, by), reflected(0)};
      }
    }
  }
  return {shadow_planes::lit(first->face), reflected(is_flat ? 1 : share / std::numbers::pi)};
}

}  // namespace moire::test
