#include "world/light_settings.h"

#include <numbers>

#include "world/faces.h"

namespace shadow_planes {

LightKind light_kind_of(const moire::Settings& settings) {
  const std::string& name = settings.text("light.kind");
  return name == "point" ? LightKind::point : name == "directional" ? LightKind::directional : LightKind::area;
}

namespace {

Vector place_of(const LightShape& shape) { return shape.at ? *shape.at : middle_of(face_of(shape.corners).parts); }

}  // namespace

std::string problem_of(const LightShape& shape, LightKind kind) {
  if (kind == LightKind::area && shape.corners.empty())
    return "has no \"points\"; light.kind \"area\" needs the polygon that shines";
  if (kind == LightKind::area && face_of(shape.corners).parts.empty())
    return "has points without area; light.kind \"area\" needs a polygon that has one";
  if (kind == LightKind::directional && shape.towards) return {};
  if (!shape.at && (shape.corners.empty() || face_of(shape.corners).parts.empty()))
    return "has no \"at\" and no polygon whose middle it could be; light.kind \"point\" needs one of them, "
           "\"directional\" them or \"towards\"";
  if (kind == LightKind::directional && length(place_of(shape)) == 0)
    return "has no \"towards\" and lies at the origin; light.kind \"directional\" needs a direction";
  return {};
}

Light light_of(const LightShape& shape, const moire::Settings& settings) {
  Light light;
  light.kind = light_kind_of(settings);
  const double brightness = settings.real("light.brightness"), distance = settings.real("light.distance");
  const double size = settings.real("light.size");
  const Vector offset{settings.real("light.x"), settings.real("light.y"), settings.real("light.z")};
  double power = std::numbers::pi * brightness;
  if (light.kind == LightKind::directional) {
    const Vector towards = (shape.towards ? *shape.towards : place_of(shape)) + offset;
    const double far = length(towards);
    light.place = far > 0 ? (1 / far) * towards : Vector{0, 0, 1};
  } else if (light.kind == LightKind::point) {
    light.place = place_of(shape) + offset;
    power *= distance * distance;
  } else {
    Face face = face_of(shape.corners);
    const Vector middle = middle_of(face.parts);
    double area = 0;
    for (Convex& part : face.parts) {
      for (Vector& p : part) p = middle + size * (p - middle) + offset;
      for (std::size_t k = 2; k < part.size(); ++k) area += length(cross(part[k - 1] - part[0], part[k] - part[0])) / 2;
    }
    light.plane = {face.plane.normal, -dot(face.plane.normal, middle + offset)};
    light.parts = std::move(face.parts);
    light.place = middle + offset;
    power *= distance * distance / area;
  }
  light.color = static_cast<float>(power) * shape.color;
  light.flat = static_cast<float>(brightness) * shape.color;
  return light;
}

}  // namespace shadow_planes
