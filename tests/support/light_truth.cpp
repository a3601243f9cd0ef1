#include "light_truth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace shadow_planes::test {

namespace {

using Real = long double;

struct Real2 {
  Real x, y;
};
using Real3 = std::array<Real, 3>;
using Shape = std::vector<Real2>;

Real3 real(Vector p) { return {p.x, p.y, p.z}; }
Real3 minus(Real3 p, Real3 q) { return {p[0] - q[0], p[1] - q[1], p[2] - q[2]}; }
Real inner(Real3 p, Real3 q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }
Real3 outer(Real3 p, Real3 q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}
Real3 unit(Real3 p) {
  const Real scale = 1 / std::sqrt(inner(p, p));
  return {scale * p[0], scale * p[1], scale * p[2]};
}

constexpr int order = 20;
struct Gauss {
  std::array<Real, order> at, weight;  // on (0, 1)
};
const Gauss& gauss() {
  static const Gauss rule = [] {
    Gauss g;
    for (int k = 0; k < order; ++k) {
      Real x = std::cos(std::numbers::pi_v<Real> * (k + 0.75L) / (order + 0.5L)), slope = 0;
      for (int step = 0; step < 20; ++step) {
        Real p = 1, before = 0;
        for (int n = 0; n < order; ++n) {
          const Real next = ((2 * n + 1) * x * p - n * before) / (n + 1);
          before = p;
          p = next;
        }
        slope = order * (x * p - before) / (x * x - 1);
        x -= p / slope;
      }
      g.at[static_cast<std::size_t>(k)] = (1 + x) / 2;
      g.weight[static_cast<std::size_t>(k)] = 1 / ((1 - x * x) * slope * slope);
    }
    return g;
  }();
  return rule;
}

// Where the horizontal line at height y is within a convex shape: from first to second, empty if not below.
std::pair<Real, Real> chord(const Shape& shape, Real y) {
  Real low = INFINITY, high = -INFINITY;
  for (std::size_t k = 0; k < shape.size(); ++k) {
    const Real2 p = shape[k], q = shape[(k + 1) % shape.size()];
    if ((p.y <= y) == (q.y <= y)) continue;
    const Real x = p.x + (y - p.y) / (q.y - p.y) * (q.x - p.x);
    low = std::min(low, x);
    high = std::max(high, x);
  }
  return {low, high};
}

}  // namespace

LightTruth light_truth(const World& world, std::size_t receiver, Vector x, Vector normal) {
  const Real3 front = unit(real(world.light.plane.normal)), origin = real(world.light.parts[0][0]);
  const Real3 across = unit(minus(real(world.light.parts[0][1]), origin)), along = outer(front, across);
  const auto placed = [&](Vector p) {
    const Real3 d = minus(real(p), origin);
    return Real3{inner(d, across), inner(d, along), inner(d, front)};
  };
  const Real3 p = placed(x), n{inner(real(normal), across), inner(real(normal), along), inner(real(normal), front)};

  std::vector<Shape> lights, casters;
  std::vector<Real> heights;
  const auto project = [&](const Convex& part, std::vector<Shape>& out) {
    Shape shape;
    // Cut off where it comes so near to the height of x that it would be seen at the horizon.
    const Real highest = (1 - 1e-5L) * p[2];
    std::vector<Real3> cut;
    for (std::size_t k = 0; k < part.size(); ++k) {
      const Real3 a = placed(part[k]), b = placed(part[(k + 1) % part.size()]);
      if (a[2] <= highest) cut.push_back(a);
      if ((a[2] <= highest) == (b[2] <= highest)) continue;
      const Real s = (highest - a[2]) / (b[2] - a[2]);
      cut.push_back({a[0] + s * (b[0] - a[0]), a[1] + s * (b[1] - a[1]), highest});
    }
    for (const Real3& a : cut) {
      // From the corner itself, which lies in the plane if it is one of a light that may be tiny.
      const Real further = a[2] / (p[2] - a[2]);
      shape.push_back({a[0] + further * (a[0] - p[0]), a[1] + further * (a[1] - p[1])});
      heights.push_back(shape.back().y);
    }
    out.push_back(shape);
  };
  for (const Convex& part : world.light.parts) project(part, lights);
  for (std::size_t k = 0; k < world.faces.size(); ++k) {
    if (k == receiver) continue;
    for (const Convex& part : world.faces[k].parts) project(part, casters);
  }
  // Crossings of any two edges.
  std::vector<std::pair<Real2, Real2>> edges;
  for (const auto* shapes : {&lights, &casters}) {
    for (const Shape& shape : *shapes) {
      for (std::size_t k = 0; k < shape.size(); ++k) edges.push_back({shape[k], shape[(k + 1) % shape.size()]});
    }
  }
  for (const auto& [a, b] : edges) {
    for (const auto& [c, d] : edges) {
      const Real2 u{b.x - a.x, b.y - a.y}, v{d.x - c.x, d.y - c.y};
      const Real area = u.x * v.y - u.y * v.x;
      if (area == 0) continue;
      const Real s = ((c.x - a.x) * v.y - (c.y - a.y) * v.x) / area;
      if (s > 0 && s < 1) heights.push_back(a.y + s * u.y);
    }
  }
  std::sort(heights.begin(), heights.end());

  Real irradiance = 0, lit = 0, whole = 0;
  for (const Shape& light : lights) {
    for (std::size_t k = 0; k < light.size(); ++k) {
      const Real2 a = light[k], b = light[(k + 1) % light.size()];
      whole += (a.x * b.y - b.x * a.y) / 2;
    }
    for (std::size_t k = 0; k + 1 < heights.size(); ++k) {
      const Real y0 = heights[k], y1 = heights[k + 1];
      if (!(y1 > y0)) continue;
      for (std::size_t row = 0; row < order; ++row) {
        const Real y = y0 + (y1 - y0) * gauss().at[row];
        const auto [left, right] = chord(light, y);
        if (!(left < right)) continue;
        std::vector<std::pair<Real, Real>> covered;
        for (const Shape& caster : casters) {
          const auto [from, to] = chord(caster, y);
          if (from < to) covered.push_back({from, to});
        }
        std::sort(covered.begin(), covered.end());
        covered.push_back({right, right});
        Real from = left;
        for (const auto& [start, end] : covered) {
          const Real to = std::min(start, right);
          if (to > from) {
            for (std::size_t column = 0; column < order; ++column) {
              const Real u = from + (to - from) * gauss().at[column];
              const Real weight = gauss().weight[row] * gauss().weight[column] * (y1 - y0) * (to - from);
              const Real3 r{u - p[0], y - p[1], -p[2]};
              lit += weight;
              irradiance += weight * inner(n, r) * p[2] / (inner(r, r) * inner(r, r));
            }
          }
          from = std::max(from, end);
        }
      }
    }
  }
  return {static_cast<double>(irradiance), static_cast<double>(lit / std::abs(whole))};
}

}  // namespace shadow_planes::test
