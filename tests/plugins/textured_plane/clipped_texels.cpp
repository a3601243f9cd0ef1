#include "plugins/textured_plane/clipped_texels.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/pieces.h"
#include "textured_plane/surroundings.h"

namespace moire::test {

namespace {

using Real = long double;

constexpr Real degree = std::numbers::pi_v<Real> / 180;

Direction3 sum(Real a, const Direction3& p, Real b, const Direction3& q, Real c, const Direction3& r) {
  return {a * p.x + b * q.x + c * r.x, a * p.y + b * q.y + c * r.y, a * p.z + b * q.z + c * r.z};
}
Real dot(const Direction3& p, const Direction3& q) { return p.x * q.x + p.y * q.y + p.z * q.z; }

// The camera's own axes, of length 1.
struct Axes {
  Direction3 right, down, forward;

  explicit Axes(const Camera& c) {
    const Real yaw = c.yaw_deg * degree, pitch = c.pitch_deg * degree, roll = c.roll_deg * degree;
    forward = {std::cos(pitch) * std::cos(yaw), std::cos(pitch) * std::sin(yaw), std::sin(pitch)};
    const Direction3 aside{-std::sin(yaw), std::cos(yaw), 0};
    const Direction3 below{std::sin(pitch) * std::cos(yaw), std::sin(pitch) * std::sin(yaw), -std::cos(pitch)};
    right = sum(std::cos(roll), aside, std::sin(roll), below, 0, forward);
    down = sum(-std::sin(roll), aside, std::cos(roll), below, 0, forward);
  }
};

Real focal(const Camera& c) { return c.size.width / 2.0L / std::tan(c.fov_deg * degree / 2); }

// A point of the plane from the camera's foot, and the part of a polygon of such points where value(point) >= 0.
struct Ground {
  Real x, y;
};
using GroundOutline = std::vector<Ground>;
template <class Value>
GroundOutline ground_part(const GroundOutline& outline, Value value) {
  GroundOutline part;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Ground &a = outline[k], &b = outline[(k + 1) % outline.size()];
    const Real va = value(a), vb = value(b);
    if (va >= 0) part.push_back(a);
    if ((va < 0) != (vb < 0)) part.push_back({a.x + va / (va - vb) * (b.x - a.x), a.y + va / (va - vb) * (b.y - a.y)});
  }
  return part;
}

}  // namespace

Direction3 ray_through(const Camera& camera, Real x, Real y) {
  const Axes axes(camera);
  return sum(x - camera.size.width / 2.0L, axes.right, y - camera.size.height / 2.0L, axes.down, focal(camera),
             axes.forward);
}

Real distance_ahead(const Camera& camera, const Direction3& ray) {
  const Real yaw = camera.yaw_deg * degree;
  return camera.height * (ray.x * std::cos(yaw) + ray.y * std::sin(yaw)) / -ray.z;
}

Clipped clipped(const Camera& camera, const Texels& texels, int x, int y) {
  const Axes axes(camera);
  const Real yaw = camera.yaw_deg * degree, f = focal(camera);
  const Real h = camera.height;
  const Outline pixel{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const auto ray = [&](Point p) { return ray_through(camera, x + static_cast<Real>(p.x), y + static_cast<Real>(p.y)); };
  const auto ground = part_of(pixel, [&](Point p) { return static_cast<double>(-ray(p).z); });
  const auto near = part_of(ground, [&](Point p) {
    const Direction3 d = ray(p);
    return static_cast<double>(camera.far * -d.z - h * (d.x * std::cos(yaw) + d.y * std::sin(yaw)));
  });
  Clipped result;
  const double sky = 1 - area_of(ground), far = area_of(ground) - area_of(near);
  if (sky > 1e-14) result.weights[background] = sky;
  if (far > 1e-14) result.weights[textured_plane::far_ground] = far;
  if (!(area_of(near) > 1e-14)) return result;

  // Texels around its corners on the plane, and how near to the camera they come.
  Real i0 = 1e30L, i1 = -i0, j0 = i0, j1 = -i0, nearest = i0;
  for (const Point& p : near) {
    const Direction3 d = ray(p);
    const Real reach = h / -d.z;
    i0 = std::min(i0, std::floor(camera.x + reach * d.x) - 1);
    i1 = std::max(i1, std::floor(camera.x + reach * d.x) + 1);
    j0 = std::min(j0, std::floor(camera.y + reach * d.y) - 1);
    j1 = std::max(j1, std::floor(camera.y + reach * d.y) + 1);
    nearest = std::min(nearest, reach * dot(d, axes.forward));
  }
  for (auto j = static_cast<std::int64_t>(j0); j <= static_cast<std::int64_t>(j1); ++j) {
    for (auto i = static_cast<std::int64_t>(i0); i <= static_cast<std::int64_t>(i1); ++i) {
      const Real west = static_cast<Real>(i) - camera.x, north = static_cast<Real>(j) - camera.y;
      GroundOutline square{{west, north}, {west + 1, north}, {west + 1, north + 1}, {west, north + 1}};
      const auto depth = [&](const Ground& g) { return dot({g.x, g.y, -h}, axes.forward); };
      square = ground_part(square, [&](const Ground& g) { return depth(g) - nearest / 2; });
      square =
          ground_part(square, [&](const Ground& g) { return camera.far - g.x * std::cos(yaw) - g.y * std::sin(yaw); });
      Outline image;
      for (const Ground& g : square) {
        const Direction3 d{g.x, g.y, -h};
        const Real scale = f / depth(g);
        image.push_back({static_cast<double>(scale * dot(d, axes.right) + camera.size.width / 2.0L - x),
                         static_cast<double>(scale * dot(d, axes.down) + camera.size.height / 2.0L - y)});
      }
      const double area = std::abs(area_of(part_in_pixel(image, 0, 0)));
      if (!(area > 0)) continue;
      const Hit hit = texels.texture().texel(0, i, j);
      result.weights[hit.element] += area;
      result.r += area * static_cast<double>(hit.color.r);
      result.g += area * static_cast<double>(hit.color.g);
      result.b += area * static_cast<double>(hit.color.b);
    }
  }
  return result;
}

}  // namespace moire::test
