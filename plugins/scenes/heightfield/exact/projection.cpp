#include "exact/projection.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace heightfield::exact {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The part of a convex polygon where value(point) is not negative.
template <class Value>
std::vector<moire::Point> half_of(const std::vector<moire::Point>& polygon, Value value) {
  std::vector<moire::Point> half;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const moire::Point a = polygon[k], b = polygon[(k + 1) % polygon.size()];
    const double va = value(a), vb = value(b);
    if (va >= 0) half.push_back(a);
    if ((va < 0) != (vb < 0)) {
      const double t = va / (va - vb);
      half.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
    }
  }
  return half;
}

}  // namespace

Projection::Projection(moire::ImageSize size, const Camera& camera, const Plane& axes) {
  const Direction origin = camera.direction(0, 0), right = camera.right(), down = camera.down();
  along_ = {axes.along(origin), axes.along(right), axes.along(down)};
  across_ = {axes.across(origin), axes.across(right), axes.across(down)};
  rise_ = {origin.z, right.z, down.z};

  // A direction is depth times the ray through its image point: Cramer's rule, the determinant left out of all three.
  const auto cross = [&](std::size_t a, std::size_t b) {
    return Form{across_[a] * rise_[b] - rise_[a] * across_[b], rise_[a] * along_[b] - along_[a] * rise_[b],
                along_[a] * across_[b] - across_[a] * along_[b]};
  };
  depth_ = cross(1, 2), x_ = cross(2, 0), y_ = cross(0, 1);
  const double determinant = along_[0] * depth_[0] + across_[0] * depth_[1] + rise_[0] * depth_[2];
  for (Form* form : {&depth_, &x_, &y_}) {
    for (double& f : *form) f /= determinant;
  }

  // Limits: twice as far along as anything in the image, and a little below and above it.
  const double width = size.width, height = size.height;
  double farthest = -infinity, low = infinity, high = -infinity;
  for (const moire::Point corner : {moire::Point{0, 0}, {width, 0}, {0, height}, {width, height}}) {
    farthest = std::max(farthest, at(along_, corner));
    low = std::min(low, at(rise_, corner));
    high = std::max(high, at(rise_, corner));
  }
  const double margin = 8 * std::abs(rise_[2]) + 1e-3 * std::max(std::abs(low), std::abs(high));
  least_depth_ = farthest > 0 ? 0.5 / farthest : infinity;
  lowest_ = low - margin, highest_ = high + margin;
}

void Projection::cut(std::span<const Vertex> polygon, std::vector<moire::Point>& out) const {
  // Homogeneous directions, of a size of 1 or so however steep they are.
  std::vector<std::array<double, 3>> from, to;
  for (const Vertex& vertex : polygon) {
    const double scale = 1 / std::max(1.0, std::abs(vertex.v));
    from.push_back({scale, scale * vertex.u, scale * vertex.v});
  }
  const auto keep = [&](auto value) {
    to.clear();
    for (std::size_t k = 0; k < from.size(); ++k) {
      const auto &a = from[k], &b = from[(k + 1) % from.size()];
      const double va = value(a), vb = value(b);
      if (va >= 0) to.push_back(a);
      if ((va < 0) == (vb < 0)) continue;
      const double t = va / (va - vb);
      to.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])});
    }
    std::swap(from, to);
  };
  using Homogeneous = std::array<double, 3>;
  const auto form = [](const Form& f, const Homogeneous& d) { return f[0] * d[0] + f[1] * d[1] + f[2] * d[2]; };
  keep([&](const Homogeneous& d) { return form(depth_, d) - least_depth_ * d[0]; });
  keep([&](const Homogeneous& d) { return d[2] - lowest_ * form(depth_, d); });
  keep([&](const Homogeneous& d) { return highest_ * form(depth_, d) - d[2]; });
  out.clear();
  for (const Homogeneous& d : from) {
    const double inverse = 1 / form(depth_, d);
    out.push_back({form(x_, d) * inverse, form(y_, d) * inverse});
  }
}

std::vector<moire::Point> Projection::part_of(const moire::Rectangle& rectangle, const Wedge& wedge) const {
  const auto& [x0, y0, x1, y1] = rectangle;
  std::vector<moire::Point> part{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  part = half_of(part, [&](moire::Point p) { return at(across_, p) - wedge.u0 * at(along_, p); });
  part = half_of(part, [&](moire::Point p) { return wedge.u1 * at(along_, p) - at(across_, p); });
  return part;
}

Wedge Projection::wedge_of(std::span<const moire::Point> part) const {
  Wedge wedge{1, 0};
  for (const moire::Point point : part) {
    const double along = at(along_, point), across = at(across_, point);
    if (!(along > least_advance)) return {0, 1};
    wedge = {std::min(wedge.u0, across / along), std::max(wedge.u1, across / along)};
  }
  return {std::max(wedge.u0, 0.0), std::min(wedge.u1, 1.0)};
}

Projection::Rises Projection::rises_of(std::span<const moire::Point> part) const {
  Rises rises{infinity, -infinity};
  for (const moire::Point point : part) {
    const double along = at(along_, point), rise = at(rise_, point);
    const double v = along > 0 ? rise / along : std::copysign(infinity, rise);
    rises = {std::min(rises.lowest, v), std::max(rises.highest, v)};
  }
  return rises;
}

Projection::Scale Projection::scale_of(std::span<const moire::Point> part) const {
  Scale scale{0, 0};
  for (const moire::Point p : part) {
    const double along = at(along_, p);
    const auto pixels = [&](std::size_t k) {
      return 2 * along * std::hypot(x_[k] - p.x * depth_[k], y_[k] - p.y * depth_[k]);
    };
    scale = {std::max(scale.per_u, pixels(1)), std::max(scale.per_v, pixels(2))};
  }
  return scale;
}

}  // namespace heightfield::exact
