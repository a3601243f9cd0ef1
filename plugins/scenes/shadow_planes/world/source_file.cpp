#include "world/source_file.h"

#include <fmt/format.h>

#include "world/faces.h"

namespace shadow_planes {

namespace {

Vector vector_of(const moire::DocumentValue& value) {
  if (value.size() != 3) value.refuse(fmt::format("has {} numbers; a place has x, y and z", value.size()));
  constexpr double largest = 1e6;
  const auto coordinate = [&](std::size_t k) { return value[k].number(-largest, largest); };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

std::vector<Vector> corners_of(const moire::DocumentValue& value) {
  constexpr std::size_t most = 1000;
  if (value.size() > most) value.refuse(fmt::format("has {} corners; {} at most are read", value.size(), most));
  std::vector<Vector> corners;
  for (std::size_t k = 0; k < value.size(); ++k) corners.push_back(vector_of(value[k]));
  if (const std::string problem = problem_of(corners); !problem.empty()) value.refuse(problem);
  return corners;
}

Face face_at(const moire::DocumentValue& value) {
  value.allow_only({"points", "reflectance", "casts", "receives", "shown"});
  Face face = face_of(corners_of(value["points"]));
  if (value.has("reflectance")) face.reflectance = value["reflectance"].color();
  if (value.has("casts")) face.casts = value["casts"].flag();
  if (value.has("receives")) face.receives = value["receives"].flag();
  if (value.has("shown")) face.shown = value["shown"].flag();
  return face;
}

LightShape light_at(const moire::DocumentValue& value) {
  value.allow_only({"points", "at", "towards", "color"});
  LightShape light;
  if (value.has("points")) light.corners = corners_of(value["points"]);
  if (value.has("at")) light.at = vector_of(value["at"]);
  if (value.has("towards")) {
    light.towards = vector_of(value["towards"]);
    if (length(*light.towards) == 0) value["towards"].refuse("is [0, 0, 0]; a direction has a length");
  }
  if (value.has("color")) light.color = value["color"].color();
  return light;
}

}  // namespace

Source read_source(const moire::Document& document) {
  const moire::DocumentValue root = document.root();
  root.allow_only({"light", "faces"});
  Source source;
  source.light = light_at(root["light"]);
  const moire::DocumentValue faces = root["faces"];
  constexpr std::size_t most = 100000;
  if (faces.size() > most) faces.refuse(fmt::format("has {} faces; {} at most are read", faces.size(), most));
  for (std::size_t k = 0; k < faces.size(); ++k) source.faces.push_back(face_at(faces[k]));
  return source;
}

}  // namespace shadow_planes
