#include "seeing/bsp.h"

#include <algorithm>
#include <limits>

#include "world/cut.h"

namespace shadow_planes {

struct Bsp::Node {
  Plane plane;
  std::vector<Fragment> within;
  std::unique_ptr<const Node> front, back;
};

namespace {

struct Reach {
  double low = std::numeric_limits<double>::infinity(), high = -low;
};

Reach reach_of(const Convex& outline, const Plane& plane) {
  Reach reach;
  for (const Vector& p : outline) {
    const double height = plane.distance(p);
    reach.low = std::min(reach.low, height);
    reach.high = std::max(reach.high, height);
  }
  return reach;
}

// The plane, of a few that are tried, that cuts the fewest; of equal ones the one with sides of like size.
std::size_t best_root(const std::vector<Bsp::Fragment>& fragments, const World& world, double tolerance) {
  constexpr std::size_t tries = 16;
  std::size_t best = 0, best_cost = std::numeric_limits<std::size_t>::max();
  const std::size_t step = std::max<std::size_t>(1, fragments.size() / tries);
  for (std::size_t k = 0; k < fragments.size(); k += step) {
    const Plane& plane = world.faces[fragments[k].face].plane;
    std::size_t cuts = 0, front = 0, back = 0;
    for (const Bsp::Fragment& fragment : fragments) {
      const Reach reach = reach_of(fragment.outline, plane);
      const bool ahead = reach.high > tolerance, behind = reach.low < -tolerance;
      cuts += ahead && behind ? 1 : 0;
      front += ahead ? 1 : 0;
      back += behind ? 1 : 0;
    }
    const std::size_t cost = 8 * cuts + std::max(front, back);
    if (cost < best_cost) best = k, best_cost = cost;
  }
  return best;
}

}  // namespace

Bsp::Bsp(const World& world) {
  std::vector<Fragment> all;
  double scale = 0;
  for (std::uint32_t k = 0; k < world.faces.size(); ++k) {
    if (!world.faces[k].shown) continue;
    for (const Convex& part : world.faces[k].parts) {
      all.push_back({k, part});
      for (const Vector& p : part) scale = std::max({scale, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
  }
  // Corners that rounding alone puts beside a plane are in it.
  root_ = node_of(std::move(all), world, 1e-12 * scale);
}

Bsp::~Bsp() = default;

std::unique_ptr<const Bsp::Node> Bsp::node_of(std::vector<Fragment> fragments, const World& world, double tolerance) {
  if (fragments.empty()) return nullptr;
  auto node = std::make_unique<Node>();
  const std::size_t root = best_root(fragments, world, tolerance);
  node->plane = world.faces[fragments[root].face].plane;
  std::vector<Fragment> front, back;
  for (std::size_t k = 0; k < fragments.size(); ++k) {
    Fragment& fragment = fragments[k];
    const Reach reach = reach_of(fragment.outline, node->plane);
    const bool ahead = reach.high > tolerance, behind = reach.low < -tolerance;
    if (k == root || (!ahead && !behind)) {
      node->within.push_back(std::move(fragment));
    } else if (ahead && behind) {
      Fragment one{fragment.face, {}}, other{fragment.face, {}};
      split(
          fragment.outline, [&](const Vector& p) { return node->plane.distance(p); }, one.outline, other.outline);
      front.push_back(std::move(one));
      back.push_back(std::move(other));
    } else {
      (ahead ? front : back).push_back(std::move(fragment));
    }
  }
  std::stable_sort(node->within.begin(), node->within.end(),
                   [](const Fragment& p, const Fragment& q) { return p.face < q.face; });
  node->front = node_of(std::move(front), world, tolerance);
  node->back = node_of(std::move(back), world, tolerance);
  return node;
}

std::vector<const Bsp::Fragment*> Bsp::front_to_back(Vector eye) const {
  std::vector<const Fragment*> result;
  const auto visit = [&](auto& self, const Node* node) -> void {
    if (!node) return;
    const double height = node->plane.distance(eye);
    self(self, height >= 0 ? node->front.get() : node->back.get());
    if (height != 0) {
      for (const Fragment& fragment : node->within) result.push_back(&fragment);
    }
    self(self, height >= 0 ? node->back.get() : node->front.get());
  };
  visit(visit, root_.get());
  return result;
}

}  // namespace shadow_planes
