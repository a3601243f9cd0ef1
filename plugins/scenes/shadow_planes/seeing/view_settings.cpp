#include "seeing/view_settings.h"

#include <numbers>

#include <moire/turn.h>

namespace shadow_planes {

namespace {

// Of the parameters that begin so.
Vector vector_of(const moire::Settings& settings, const std::string& name) {
  return {settings.real(name + "x"), settings.real(name + "y"), settings.real(name + "z")};
}

// To the right of who looks this way: level; of who looks straight up or down, along x.
Vector level_right(const Vector& ahead) {
  const double across = std::hypot(ahead.x, ahead.y);
  return across > 0 ? Vector{ahead.y / across, -ahead.x / across, 0} : Vector{1, 0, 0};
}

}  // namespace

Camera camera_of(const moire::Settings& settings, moire::ImageSize size) {
  Camera camera;
  camera.size = size;
  camera.eye = vector_of(settings, "view.");
  Vector right;
  if (settings.text("view.aim") == "target") {
    const Vector way = vector_of(settings, "view.target_") - camera.eye;
    const double far = length(way);
    camera.ahead = far > 0 ? (1 / far) * way : Vector{0, 1, 0};
    right = level_right(camera.ahead);
  } else {
    const moire::Turn yaw = moire::turn_of(settings.real("view.yaw_deg"));
    const moire::Turn pitch = moire::turn_of(settings.real("view.pitch_deg"));
    camera.ahead = {pitch.cosine * yaw.cosine, pitch.cosine * yaw.sine, pitch.sine};
    right = {yaw.sine, -yaw.cosine, 0};
  }
  const Vector down = cross(camera.ahead, right);
  const moire::Turn roll = moire::turn_of(settings.real("view.roll_deg"));
  camera.right = roll.cosine * right + roll.sine * down;
  camera.down = roll.cosine * down - roll.sine * right;
  camera.focal = 0.5 * size.width / std::tan(settings.real("view.fov_deg") * (std::numbers::pi / 360));
  return camera;
}

}  // namespace shadow_planes
