#include "soft_scenes.h"

#include <cmath>
#include <numbers>

#include <moire/turn.h>

namespace shadow_planes::test {

Convex rectangle(Vector corner, Vector side, Vector other_side) {
  return {corner, corner + side, corner + side + other_side, corner + other_side};
}

Face face_of(Convex outline) {
  Vector normal = cross(outline[1] - outline[0], outline[2] - outline[1]);
  normal = (1 / length(normal)) * normal;
  Face face;
  face.plane = {normal, -dot(normal, outline[0])};
  face.parts.push_back(std::move(outline));
  return face;
}

World lit_receiver() {
  World world;
  world.faces.push_back(face_of(rectangle({-3, -3, 0}, {6, 0, 0}, {0, 6, 0})));
  world.faces[0].reflectance = {1, 1, 1};
  const moire::Turn turn = moire::turn_of(17);
  const Vector u{turn.cosine, turn.sine, 0}, v{-turn.sine, turn.cosine, 0};
  world.light.plane = {{0, 0, -1}, 4};
  world.light.parts = {rectangle(Vector{0, 0, 4} - 0.5 * u - 0.5 * v, v, u)};
  // Irradiance below the middle of a square of half side a at height h: 4 a / r atan(a / r), r^2 = a^2 + h^2, twice
  // for the two pairs of edges.
  const double r = std::hypot(0.5, 4.0), under = 4 * (0.5 / r) * std::atan(0.5 / r);
  const auto color = static_cast<float>(std::numbers::pi / under);
  world.light.color = {color, color, color};
  world.ambient = {0, 0, 0};
  return world;
}

std::vector<SoftScene> soft_scenes() {
  const moire::Turn turn = moire::turn_of(17);
  const Vector u{turn.cosine, turn.sine, 0}, v{-turn.sine, turn.cosine, 0};
  std::vector<SoftScene> scenes;
  const auto add = [&](const char* name, const std::vector<Convex>& casters) {
    World world = lit_receiver();
    for (const Convex& caster : casters) world.faces.push_back(face_of(caster));
    scenes.push_back({name, std::move(world)});
  };
  add("one tilted quad", {rectangle({-0.7, -0.55, 1.3}, {1.3, 0.2, 0.35}, {-0.15, 1.1, 0.25})});
  add("parallel quad", {rectangle(Vector{0, 0, 1.5} - 0.5 * u - 0.6 * v, u, 1.2 * v)});
  add("three disjoint", {rectangle({-1.7, -0.5, 1.2}, {0.8, 0.1, 0.2}, {-0.1, 0.9, 0.1}),
                         rectangle({-0.3, -0.8, 1.6}, {0.7, -0.2, 0.1}, {0.2, 0.7, -0.3}),
                         rectangle({0.9, 0.2, 1}, {0.9, 0.3, -0.1}, {-0.3, 0.8, 0.2})});
  add("wall and overlapping pair", {rectangle({-1.6, -1.1, 0}, {1.5, 0.3, 0}, {0, 0, 1.1}),
                                    rectangle({0.2, -0.4, 1.1}, {1.1, 0.1, 0.2}, {0, 0.9, 0}),
                                    rectangle({0.6, 0, 1.7}, {0.8, -0.2, 0}, {0.2, 0.8, 0.3})});
  std::vector<Convex> slats;
  for (int k = 0; k < 8; ++k) {
    slats.push_back(rectangle({-1.2 + 0.3 * k, -1, 1.2 + 0.02 * k}, {0.15, 0.01 * k, 0.05}, {0.05, 2, 0.1}));
  }
  add("8 slats", slats);
  return scenes;
}

Camera overhead(moire::ImageSize size) {
  Camera camera;
  camera.size = size;
  camera.eye = {0, 0, 10};
  camera.right = {1, 0, 0};
  camera.down = {0, -1, 0};
  camera.ahead = {0, 0, -1};
  camera.focal = size.width * 10 / 6.0;
  return camera;
}

Camera grazing(moire::ImageSize size) {
  Camera camera;
  camera.size = size;
  const moire::Turn pitch = moire::turn_of(15), heading = moire::turn_of(30);
  camera.ahead = {pitch.cosine * heading.cosine, pitch.cosine * heading.sine, -pitch.sine};
  camera.right = {heading.sine, -heading.cosine, 0};
  camera.down = cross(camera.ahead, camera.right);
  camera.eye = Vector{0, 0, 0.3} - 5 * camera.ahead;
  camera.focal = 0.9 * size.width;
  return camera;
}

}  // namespace shadow_planes::test
