// What a scene consists of: planar faces, one light.
#pragma once

#include <cstdint>
#include <vector>

#include <moire/color.h>
#include <moire/element.h>

#include "world/space.h"

namespace shadow_planes {

// A convex polygon in one plane, counterclockwise seen from the side that the plane's normal points to.
using Convex = std::vector<Vector>;

// A flat polygon, opaque and seen from both sides. What is lit is the side that faces the light.
struct Face {
  Plane plane;
  std::vector<Convex> parts;  // convex and disjoint; their union is the face. None: it has no area
  moire::Color reflectance{0.5F, 0.5F, 0.5F};
  bool casts = true;     // shadows, onto others
  bool receives = true;  // shadows; others are lit wherever they face the light
  bool shown = true;     // to the camera; others only cast shadows
};

enum class LightKind { point, directional, area };

// What reaches a surface from it is, divided by pi, what a surface of reflectance 1 sends out: a colour.
struct Light {
  LightKind kind = LightKind::area;
  // Of point: where it is. Of directional: the direction towards it, of length 1.
  Vector place{0, 0, 4};
  // Of area: it sends out light on the side that the plane's normal points to. Convex and disjoint parts.
  Plane plane{{0, 0, -1}, 4};
  std::vector<Convex> parts;
  // Of area: radiance. Of point: radiant intensity. Of directional: irradiance of a surface that faces it.
  moire::Color color{1, 1, 1};
  moire::Color flat{1, 1, 1};  // what any lit surface of reflectance 1 sends out, where shading is flat
};

struct World {
  std::vector<Face> faces;
  Light light;
  moire::Color ambient{0.1F, 0.1F, 0.1F};  // radiance that all surfaces get from everywhere, before reflectance
  moire::Color sky{0.5F, 0.6F, 0.8F};      // what is seen where there is no face
};

// Elements of face k: where it is lit, where face `by` shadows it (of several that hide a point of the light, the first
// of the list), and where it gets no light whatever hides it.
constexpr moire::Element lit(std::uint32_t face) { return (static_cast<moire::Element>(face) + 1) << 32; }
constexpr moire::Element shadowed(std::uint32_t face, std::uint32_t by) { return lit(face) + by + 1; }
constexpr moire::Element unlit(std::uint32_t face) { return lit(face) + 0xffffffffU; }

}  // namespace shadow_planes
