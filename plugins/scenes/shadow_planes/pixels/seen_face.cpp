#include "pixels/seen_face.h"

namespace shadow_planes {

namespace {

// The face's plane, its normal to the eye's side.
Plane seen_side(Plane plane, Vector eye) { return plane.distance(eye) < 0 ? Plane{-plane.normal, -plane.d} : plane; }

}  // namespace

SeenFace::SeenFace(const World& world, std::uint32_t face, const Camera& camera, moire::ImageSize size)
    : face_(face),
      camera_(camera),
      illumination_(illumination_of(world, face, seen_side(world.faces[face].plane, camera.eye))),
      height_(illumination_->side().distance(camera.eye)),
      segments_(critical_lines(world, *illumination_), camera, size) {
  if (world.light.kind != LightKind::area) return;
  for (const Vector& contact : shadow_planes::contacts(*illumination_)) {
    const moire::Pole p = camera.image_of({contact.x, contact.y, contact.z, 1});
    if (p.w > 0) contacts_.push_back({p.x / p.w, p.y / p.w});
  }
}

}  // namespace shadow_planes
