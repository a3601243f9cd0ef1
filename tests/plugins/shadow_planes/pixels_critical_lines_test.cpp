// Between two points that no critical line separates, the same casters hide the same parts of the light.
#include <cmath>
#include <random>

#include "pixels/critical_lines.h"
#include "support/soft_scenes.h"

using namespace shadow_planes;
using namespace shadow_planes::test;

namespace {

// Of the receiver z = 0; far points of rays are 1e6 away.
moire::Point end_of(const Homogeneous& end, const Homogeneous& other) {
  if (end.w > 0) return {end.x / end.w, end.y / end.w};
  const double scale = 1e6 / std::hypot(end.x, end.y);
  return {other.x / other.w + scale * end.x, other.y / other.w + scale * end.y};
}

bool separates(const CriticalLine& line, moire::Point p, moire::Point q) {
  const moire::Point a = end_of(line.from, line.to), b = end_of(line.to, line.from);
  const auto side = [](moire::Point from, moire::Point to, moire::Point at) {
    return (to.x - from.x) * (at.y - from.y) - (to.y - from.y) * (at.x - from.x);
  };
  constexpr double near = 1e-9;
  const double u = side(a, b, p), v = side(a, b, q), s = side(p, q, a), t = side(p, q, b);
  const double length = std::hypot(b.x - a.x, b.y - a.y) + 1;
  return std::min(u, v) <= near * length && std::max(u, v) >= -near * length && std::min(s, t) <= near * length &&
         std::max(s, t) >= -near * length;
}

struct Sight {
  std::vector<std::uint32_t> met;
  int lit;  // none, some, all
  bool overlap;
  friend bool operator==(const Sight&, const Sight&) = default;
};

}  // namespace

TEST_CASE("who hides the light changes only across critical lines", "[shadow_planes]") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-2.9, 2.9), step(-0.08, 0.08);
  for (const SoftScene& scene : soft_scenes()) {
    INFO(scene.name);
    const auto illumination = illumination_of(scene.world, 0, scene.world.faces[0].plane);
    const std::vector<CriticalLine> lines = critical_lines(scene.world, *illumination);
    Illumination::Scratch scratch;
    const auto sight = [&](moire::Point p) {
      const Reach reach = illumination->at({p.x, p.y, 0}, illumination->all(), scratch);
      return Sight{scratch.met, reach.lit == 0 ? 0 : reach.lit < 1 ? 1 : 2, scratch.overlap};
    };
    int changes = 0, quiet = 0;
    for (int k = 0; k < 20000; ++k) {
      const moire::Point p{place(random), place(random)}, q{p.x + step(random), p.y + step(random)};
      const Sight at_p = sight(p), at_q = sight(q);
      const bool separated =
          std::any_of(lines.begin(), lines.end(), [&](const CriticalLine& line) { return separates(line, p, q); });
      quiet += !separated;
      if (at_p.met == at_q.met && at_p.lit == at_q.lit) continue;
      ++changes;
      // Casters that overlap may together close the light on a curve.
      if (at_p.met == at_q.met && (at_p.overlap || at_q.overlap)) continue;
      CHECK(separated);
    }
    CHECK(changes > 50);
    CHECK(quiet > 5000);
  }
}

TEST_CASE("a standing caster is critical along its foot, a slanting one where it is seen edge-on", "[shadow_planes]") {
  World world = lit_receiver();
  world.light.parts = {rectangle({-0.5, -0.5, 4}, {0, 1, 0}, {1, 0, 0})};
  world.faces.push_back(face_of(rectangle({0, -1, 0}, {0, 2, 0}, {0, 0, 1})));
  const auto illumination = illumination_of(world, 0, world.faces[0].plane);
  const auto lines = critical_lines(world, *illumination);
  // The plane x = 0 cuts the light from y = -1/2 to 1/2. Seen through the wall's upper corners, 1 up at y = -1 and 1,
  // those ends are over (4 * 1 + 1/2) / 3 to either side.
  const bool found = std::any_of(lines.begin(), lines.end(), [](const CriticalLine& line) {
    const moire::Point a = end_of(line.from, line.to), b = end_of(line.to, line.from);
    return std::abs(a.x) < 1e-12 && std::abs(b.x) < 1e-12 && std::abs(std::max(a.y, b.y) - 4.5 / 3) < 1e-12 &&
           std::abs(std::min(a.y, b.y) + 4.5 / 3) < 1e-12;
  });
  CHECK(found);
  REQUIRE(contacts(*illumination).size() == 2);
}

TEST_CASE("a corner of one caster is critical where it is seen on an edge of another before the light",
          "[shadow_planes]") {
  for (const bool corner_is_higher : {true, false}) {
    World world = lit_receiver();
    world.light.parts = {rectangle({-0.5, -0.5, 4}, {0, 1, 0}, {1, 0, 0})};
    // The corner over x = 0, the edge over x = 1/10, one of them 2 up and the other 1.
    const double corner_at = corner_is_higher ? 2 : 1, edge_at = 3 - corner_at;
    world.faces.push_back(face_of({{0, 0, corner_at}, {-1, -1, corner_at}, {-1, 1, corner_at}}));
    world.faces.push_back(face_of(rectangle({0.1, -1, edge_at}, {1, 0, 0}, {0, 2, 0})));
    const auto illumination = illumination_of(world, 0, world.faces[0].plane);
    const auto lines = critical_lines(world, *illumination);
    // Rays through both meet the receiver at x = 1/5 or -1/10. They leave the light at (-1/5, y) or (3/10, y) with y
    // from -1/2 to 1/2, and run through the corner, so that they arrive at -y or -y / 3.
    const double x = corner_is_higher ? 0.2 : -0.1, y = corner_is_higher ? 0.5 : 0.5 / 3;
    CHECK(std::any_of(lines.begin(), lines.end(), [&](const CriticalLine& line) {
      const moire::Point a = end_of(line.from, line.to), b = end_of(line.to, line.from);
      return std::abs(a.x - x) < 1e-12 && std::abs(b.x - x) < 1e-12 && std::abs(std::max(a.y, b.y) - y) < 1e-12 &&
             std::abs(std::min(a.y, b.y) + y) < 1e-12;
    }));
  }
}
