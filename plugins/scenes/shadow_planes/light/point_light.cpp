#include "light/point_light.h"

#include <algorithm>

namespace shadow_planes {

namespace {

// Whether the ray from x along `direction` meets the caster: it runs within the planes through x and the edges.
bool hides(const Caster& caster, Vector x, Vector direction) {
  const double volume = caster.plane.distance(x);
  double size = 0;
  for (const Vector& corner : caster.corners) size = std::max(size, length(corner - x));
  if (std::abs(volume) <= 1e-12 * size) return false;
  const double sign = volume > 0 ? -1 : 1;
  Vector from = caster.corners.back() - x;
  for (const Vector& corner : caster.corners) {
    const Vector to = corner - x;
    if (sign * dot(cross(from, to), direction) < 0) return false;
    from = to;
  }
  return true;
}

}  // namespace

Reach PointLight::at(Vector x, std::span<const std::uint32_t> candidates, Scratch& scratch) const {
  scratch.hidden.clear();
  scratch.met.clear();
  scratch.overlap = false;
  const Vector direction = is_point_ ? place_ - x : place_;
  const double height = dot(side().normal, direction), squared = dot(direction, direction);
  if (!(height > 0)) return {};
  for (const std::uint32_t caster : candidates) {
    if (!hides(casters()[caster], x, direction)) continue;
    scratch.met.push_back(caster);
    if (scratch.hidden.empty()) scratch.hidden.push_back({caster, 1});
  }
  if (!scratch.hidden.empty()) return {};
  return {is_point_ ? height / (squared * std::sqrt(squared)) : height, 1};
}

// One is looked at in the time that it takes to leave it out.
void PointLight::narrow(std::span<const Vector>, std::span<const std::uint32_t> candidates,
                        std::vector<std::uint32_t>& out) const {
  out.assign(candidates.begin(), candidates.end());
}

}  // namespace shadow_planes
