// What a point of a face shows.
#pragma once

#include <numbers>
#include <vector>

#include <moire/texture.h>

#include "hard/occluders.h"
#include "world/light_points.h"

namespace shadow_planes {

enum class Shade {
  diffuse,  // by the light's distance and by how the surface is turned to it
  flat,     // lit is lit: one colour, as in drawings and in the shadows of early games
};

class Shading {
 public:
  // `world` and `occluders` outlive this.
  Shading(const World& world, const Occluders& occluders, Vector eye, Shade shade);

  // Requires: a face that is not seen edge-on.
  moire::Hit at(std::uint32_t face, const Vector& point, double u, double v) const;

  // The irradiance that light of this place brings to a point if nothing hides it: of an area light, as if all of its
  // power came from there; with Shade::flat, 1 where it falls on the surface. 0: none falls on this side.
  double irradiance(const Plane& side, const Vector& point, const Homogeneous& light) const;
  // Reflected, ambient light included.
  moire::Color color(std::uint32_t face, double irradiance) const;

  const Receiver& receiver(std::uint32_t face) const { return receivers_[face]; }
  const LightPoints& light() const { return light_; }

 private:
  const World& world_;
  const Occluders& occluders_;
  Shade shade_;
  LightPoints light_;
  std::vector<Receiver> receivers_;
};

}  // namespace shadow_planes
