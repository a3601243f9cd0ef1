#include "seeing/shading.h"

#include <algorithm>

namespace shadow_planes {

Shading::Shading(const World& world, const Occluders& occluders, Vector eye, Shade shade)
    : world_(world), occluders_(occluders), shade_(shade), light_(world.light) {
  for (std::uint32_t k = 0; k < world.faces.size(); ++k) receivers_.push_back(occluders.receiver(k, eye));
}

double Shading::irradiance(const Plane& side, const Vector& point, const Homogeneous& light) const {
  if (!occluders_.faces(side, light)) return 0;
  if (light.w == 0) return shade_ == Shade::flat ? 1 : side.of(light);
  const Vector way = Vector{light.x, light.y, light.z} - point;
  const bool is_area = world_.light.kind == LightKind::area;
  const double sent = is_area ? std::max(0.0, -dot(world_.light.plane.normal, way)) : 1;
  if (shade_ == Shade::flat) return sent > 0 ? 1 : 0;
  // cos / r^2, or area cos cos' / r^2.
  const double square = dot(way, way);
  const double kernel = side.of(light) / (square * std::sqrt(square));
  return is_area ? light_.area() * kernel * sent / std::sqrt(square) : kernel;
}

moire::Color Shading::color(std::uint32_t face, double irradiance) const {
  const moire::Color& reflectance = world_.faces[face].reflectance;
  const Light& light = world_.light;
  const moire::Color& sent = shade_ == Shade::flat ? light.flat : light.color;
  const double part = shade_ == Shade::flat ? irradiance : irradiance / std::numbers::pi;
  const auto channel = [&](float r, float ambient, float of_light) {
    return static_cast<float>(static_cast<double>(r) *
                              (static_cast<double>(ambient) + part * static_cast<double>(of_light)));
  };
  return {channel(reflectance.r, world_.ambient.r, sent.r), channel(reflectance.g, world_.ambient.g, sent.g),
          channel(reflectance.b, world_.ambient.b, sent.b)};
}

moire::Hit Shading::at(std::uint32_t face, const Vector& point, double u, double v) const {
  const Receiver& receiver = receivers_[face];
  const Homogeneous light = light_.at(u, v);
  const double light_there = irradiance(receiver.side, point, light);
  if (!(light_there > 0)) return {unlit(face), color(face, 0)};
  const std::uint32_t by = occluders_.first_that_hides(receiver, point, light);
  return by == Occluders::none ? moire::Hit{lit(face), color(face, light_there)}
                               : moire::Hit{shadowed(face, by), color(face, 0)};
}

}  // namespace shadow_planes
