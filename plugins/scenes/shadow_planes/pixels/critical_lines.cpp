#include "pixels/critical_lines.h"

#include <algorithm>

namespace shadow_planes {

namespace {

Homogeneous homogeneous(Vector p) { return {p.x, p.y, p.z, 1}; }
Vector direction_of(const Homogeneous& p) { return {p.x, p.y, p.z}; }

// An interval of a line of the receiver. Its ends have w >= 0.
struct Interval {
  Homogeneous low, high;
};

// Points of a line of the receiver in their order along it.
class AlongLine {
 public:
  explicit AlongLine(Vector direction) : direction_(direction) {}

  bool is_before(const Homogeneous& p, const Homogeneous& q) const {
    const double at_p = dot(direction_, direction_of(p)), at_q = dot(direction_, direction_of(q));
    return p.w == 0 && q.w == 0 ? at_p < at_q : at_p * q.w < at_q * p.w;
  }
  Interval ordered(const CriticalLine& line) const {
    return is_before(line.to, line.from) ? Interval{line.to, line.from} : Interval{line.from, line.to};
  }
  Interval hull(const Interval& a, const Interval& b) const {
    return {is_before(b.low, a.low) ? b.low : a.low, is_before(a.high, b.high) ? b.high : a.high};
  }
  Interval common(const Interval& a, const Interval& b) const {
    return {is_before(b.low, a.low) ? a.low : b.low, is_before(a.high, b.high) ? a.high : b.high};
  }

 private:
  Vector direction_;
};

class Finder {
 public:
  Finder(const World& world, const Illumination& illumination)
      : side_(illumination.side()), illumination_(illumination) {
    if (world.light.kind == LightKind::area) {
      for (const Convex& part : world.light.parts) {
        if (Convex seen = clipped(part, side_); !seen.empty()) lights_.push_back(std::move(seen));
      }
    }
  }

  void area(const Plane& light) {
    if (lights_.empty()) return;
    for (const Caster& caster : illumination_.casters()) {
      const Convex& corners = caster.corners;
      for (std::size_t k = 0; k < corners.size(); ++k) {
        for (const Convex& part : lights_) {
          for (std::size_t v = 0; v < part.size(); ++v) {
            const Vector corner = part[v], next = part[(v + 1) % part.size()];
            add(homogeneous(corner), corners[k], homogeneous(corner), corners[(k + 1) % corners.size()]);
            add(homogeneous(corner), corners[k], homogeneous(next), corners[k]);
          }
        }
      }
      edge_on(caster);
      for (const Caster& other : illumination_.casters()) {
        if (&other != &caster) corners_and_edges(caster, other);
      }
    }
    lights_own(light);
  }

  void point(const Light& light) {
    const Vector p = light.place;
    const Homogeneous place{p.x, p.y, p.z, light.kind == LightKind::point ? 1.0 : 0.0};
    if (!(side_.of(place) > 0)) return;
    for (const Caster& caster : illumination_.casters()) {
      const Convex& corners = caster.corners;
      for (std::size_t k = 0; k < corners.size(); ++k) add(place, corners[k], place, corners[(k + 1) % corners.size()]);
    }
  }

  std::vector<CriticalLine> found;

 private:
  // Where the line through a point of the light and one of a caster meets the receiver; w is above 0 if it does so on
  // the caster's far side. (The shadow matrix: S = (L.G) P - (P.G) L.)
  Homogeneous shadow(const Homogeneous& l, Vector p) const {
    const double top = side_.of(l), height = side_.distance(p);
    return {top * p.x - height * l.x, top * p.y - height * l.y, top * p.z - height * l.z, top - l.w * height};
  }
  // The part of the segment between two shadows that has w >= 0. False: nothing.
  static bool ahead(Homogeneous a, Homogeneous b, CriticalLine& line) {
    if (a.w <= 0 && b.w <= 0) return false;
    if (a.w < 0) std::swap(a, b);
    if (b.w < 0) {
      const double share = a.w / (a.w - b.w);
      b = {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y), a.z + share * (b.z - a.z), 0};
    }
    line = {a, b};
    return true;
  }
  static Homogeneous negative(const Homogeneous& p) { return {-p.x, -p.y, -p.z, -p.w}; }

  // Linear between the two, as one of light and caster is the same in both.
  void add(const Homogeneous& l, Vector p, const Homogeneous& m, Vector q) {
    CriticalLine line;
    if (ahead(shadow(l, p), shadow(m, q), line)) found.push_back(line);
  }

  // Where the plane meets a convex polygon: the ends of a segment. Fewer than two: it does not cut it.
  static std::vector<Vector> section(const Convex& polygon, const Plane& plane, double tolerance) {
    std::vector<Vector> ends;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Vector p = polygon[k], q = polygon[(k + 1) % polygon.size()];
      const double at_p = plane.distance(p), at_q = plane.distance(q);
      if (std::abs(at_p) <= tolerance) {
        ends.push_back(p);
      } else if ((at_p > tolerance && at_q < -tolerance) || (at_p < -tolerance && at_q > tolerance)) {
        ends.push_back(p + (at_p / (at_p - at_q)) * (q - p));
      }
    }
    return ends;
  }

  // (4): from where a caster is seen edge-on before the light.
  void edge_on(const Caster& caster) {
    const Vector direction = cross(caster.plane.normal, side_.normal);
    if (dot(direction, direction) == 0) return;
    const AlongLine along(direction);
    const Convex& corners = caster.corners;
    for (const Convex& part : lights_) {
      const std::vector<Vector> ends = section(part, caster.plane, 1e-12 * reach_of(corners, part));
      if (ends.size() < 2) continue;
      bool any = false;
      Interval seen;
      for (const Vector& end : ends) {
        for (std::size_t k = 0; k < corners.size(); ++k) {
          CriticalLine line;
          const Homogeneous light = homogeneous(end);
          if (!ahead(shadow(light, corners[k]), shadow(light, corners[(k + 1) % corners.size()]), line)) continue;
          const Interval one = along.ordered(line);
          seen = any ? along.hull(seen, one) : one;
          any = true;
        }
      }
      if (any) found.push_back({seen.low, seen.high});
    }
  }

  // (3): where corners of one caster are seen on edges of another, with the light behind them.
  void corners_and_edges(const Caster& caster, const Caster& other) {
    for (const Vector& corner : caster.corners) {
      const double height = side_.distance(corner);
      if (!(height > 0)) continue;
      for (std::size_t k = 0; k < other.corners.size(); ++k) {
        const Vector b = other.corners[k], c = other.corners[(k + 1) % other.corners.size()];
        Vector normal = cross(b - corner, c - corner);
        const double size = length(normal);
        if (size == 0) continue;
        normal = (1 / size) * normal;
        const Plane plane{normal, -dot(normal, corner)};
        const Vector direction = cross(normal, side_.normal);
        if (dot(direction, direction) == 0) continue;
        for (const Convex& part : lights_) {
          const std::vector<Vector> ends = section(part, plane, 1e-12 * reach_of(other.corners, part));
          if (ends.size() < 2) continue;
          const AlongLine along(direction);
          CriticalLine line;
          if (!ahead(shadow(homogeneous(ends[0]), corner), shadow(homogeneous(ends[1]), corner), line)) continue;
          const Interval lit = along.ordered(line);
          // The edge behind the corner, and before it.
          const Homogeneous to_b = shadow(homogeneous(corner), b), to_c = shadow(homogeneous(corner), c);
          for (const bool is_behind : {false, true}) {
            if (!ahead(is_behind ? negative(to_b) : to_b, is_behind ? negative(to_c) : to_c, line)) continue;
            const Interval both = along.common(lit, along.ordered(line));
            if (along.is_before(both.low, both.high)) found.push_back({both.low, both.high});
          }
        }
      }
    }
  }

  // (5): in one plane with the light.
  void lights_own(const Plane& light) {
    const Vector direction = cross(light.normal, side_.normal);
    const double squared = dot(direction, direction);
    if (squared <= 1e-24) return;
    // The point of both planes that is nearest to the origin.
    const Vector at =
        (1 / squared) * (light.d * cross(direction, side_.normal) - side_.d * cross(direction, light.normal));
    found.push_back({homogeneous(at), {direction.x, direction.y, direction.z, 0}});
    found.push_back({homogeneous(at), {-direction.x, -direction.y, -direction.z, 0}});
  }

  static double reach_of(const Convex& corners, const Convex& part) {
    double farthest = 0;
    for (const Vector& p : part) farthest = std::max(farthest, length(p - corners[0]));
    return farthest;
  }

  const Plane& side_;
  const Illumination& illumination_;
  std::vector<Convex> lights_;
};

}  // namespace

std::vector<CriticalLine> critical_lines(const World& world, const Illumination& illumination) {
  Finder finder(world, illumination);
  if (world.light.kind == LightKind::area) {
    finder.area(world.light.plane);
  } else {
    finder.point(world.light);
  }
  return std::move(finder.found);
}

std::vector<Vector> contacts(const Illumination& illumination) {
  std::vector<Vector> found;
  for (const Caster& caster : illumination.casters()) {
    double highest = 0;
    for (const Vector& corner : caster.corners) highest = std::max(highest, illumination.side().distance(corner));
    for (const Vector& corner : caster.corners) {
      if (illumination.side().distance(corner) <= 1e-12 * highest) found.push_back(corner);
    }
  }
  return found;
}

}  // namespace shadow_planes
