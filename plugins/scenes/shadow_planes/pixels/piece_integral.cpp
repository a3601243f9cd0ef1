#include "pixels/piece_integral.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "light/triangle_rule.h"

namespace shadow_planes {

namespace {

// Divisions of a triangle, and of an angle at a contact.
constexpr int deepest = 8;
// Pieces of less than this part of a pixel are as good as their middle.
constexpr double negligible = 1e-8;

moire::Point middle(moire::Point p, moire::Point q) { return {0.5 * (p.x + q.x), 0.5 * (p.y + q.y)}; }

struct Moments {
  double area;
  moire::Point centroid;
  double xx, xy, yy;  // central second moments over the area
};

Moments moments_of(const Outline& outline) {
  // About the first corner, as a sum of triangles.
  const moire::Point o = outline[0];
  double area = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  for (std::size_t k = 2; k < outline.size(); ++k) {
    const double px = outline[k - 1].x - o.x, py = outline[k - 1].y - o.y;
    const double qx = outline[k].x - o.x, qy = outline[k].y - o.y;
    const double twice = px * qy - qx * py;
    area += twice / 2;
    x += twice * (px + qx) / 6;
    y += twice * (py + qy) / 6;
    xx += twice * (px * px + px * qx + qx * qx) / 12;
    yy += twice * (py * py + py * qy + qy * qy) / 12;
    xy += twice * (2 * px * py + px * qy + qx * py + 2 * qx * qy) / 24;
  }
  x /= area, y /= area;
  return {area, {o.x + x, o.y + y}, xx / area - x * x, xy / area - x * y, yy / area - y * y};
}

}  // namespace

double PieceIntegral::Triangle::area() const { return 0.5 * ((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y)); }

bool PieceIntegral::is_good(const Integral& integral, double area) const {
  // Small pieces may err more by area: there are few of them.
  return integral.error <= tolerance_ * std::max(area, 0.1);
}

Integral PieceIntegral::over(const Outline& outline, const moire::Point* contact,
                             std::span<const std::uint32_t> candidates) {
  const double area = 0.5 * doubled_area(outline);
  if (!(area > 0)) return {};
  if (contact) {
    const auto same = [&](const moire::Point& p) { return std::hypot(p.x - contact->x, p.y - contact->y) < 1e-9; };
    const auto found = std::find_if(outline.begin(), outline.end(), same);
    if (found != outline.end()) {
      const auto from = static_cast<std::size_t>(found - outline.begin());
      const auto corner = [&](std::size_t k) { return outline[(from + k) % outline.size()]; };
      Integral sum;
      for (std::size_t k = 2; k < outline.size(); ++k) {
        const Integral part = around({corner(0), corner(k - 1), corner(k)}, candidates, 0);
        sum = {sum.sums + part.sums, sum.error + part.error};
      }
      return sum;
    }
  }
  if (outline.size() == 3) return triangle({outline[0], outline[1], outline[2]}, candidates, 0);
  const std::size_t mark = gatherer_.mark();
  const Integral rough = whole(outline, area, candidates);
  if (is_good(rough, area)) return rough;
  gatherer_.forget(mark);
  Integral sum;
  for (std::size_t k = 2; k < outline.size(); ++k) {
    const Integral part = triangle({outline[0], outline[k - 1], outline[k]}, candidates, 1);
    sum = {sum.sums + part.sums, sum.error + part.error};
  }
  return sum;
}

// Two rules of three points, each exact for polynomials of degree 2 over any convex outline: points on the ellipse
// sqrt 2 times that of inertia, which lies within the outline (Kannan, Lovasz, Simonovits 1995, "Isoperimetric problems
// for convex bodies and a localization lemma", theorem 4.1). The rules are mirror images in the centroid, so that what
// they differ by is of the third order, and as large as it gets over the outline.
Integral PieceIntegral::whole(const Outline& outline, double area, std::span<const std::uint32_t> candidates) {
  const Moments m = moments_of(outline);
  if (area < negligible) return {gatherer_.at(face_, m.centroid, candidates, area), 0};
  const double l11 = std::sqrt(std::max(m.xx, 0.0)), l21 = l11 > 0 ? m.xy / l11 : 0;
  const double l22 = std::sqrt(std::max(m.yy - l21 * l21, 0.0));
  constexpr double half_root_3 = 0.86602540378443865, root_2 = 1.4142135623730951;
  constexpr std::array<moire::Point, 3> corners{{{0, 1}, {-half_root_3, -0.5}, {half_root_3, -0.5}}};
  Sums one, other;
  bool is_first = true;
  for (const double sign : {root_2, -root_2}) {
    Sums& sums = sign > 0 ? one : other;
    for (const moire::Point& u : corners) {
      const moire::Point p{m.centroid.x + sign * l11 * u.x, m.centroid.y + sign * (l21 * u.x + l22 * u.y)};
      sums = sums + gatherer_.at(face_, p, is_first ? candidates : std::span<const std::uint32_t>(met_), area / 6);
      if (is_first) met_.assign(gatherer_.scratch.met.begin(), gatherer_.scratch.met.end());
      is_first = false;
    }
  }
  return {one + other, std::abs(one.light - other.light)};
}

// Seven points, of degree 5, held against four of them, of degree 2: the middle and the corners of the inner triangle
// (positive weights, from the moments).
Integral PieceIntegral::triangle(const Triangle& t, std::span<const std::uint32_t> candidates, int depth) {
  const double area = t.area();
  if (!(area > 0)) return {};
  const std::size_t mark = gatherer_.mark();
  Integral result;
  double rough = 0;
  constexpr double near = 0.10128650732345634;
  constexpr double corner = (1.0 / 2 - 1.0 / 3) / (2 * near * near + (1 - 2 * near) * (1 - 2 * near) - 1.0 / 3) / 3;
  for (std::size_t k = 0; k < seven_points.size(); ++k) {
    const TrianglePoint& at = seven_points[k];
    const moire::Point p{at.a * t.a.x + at.b * t.b.x + at.c * t.c.x, at.a * t.a.y + at.b * t.b.y + at.c * t.c.y};
    if (area < negligible) return {gatherer_.at(face_, p, candidates, area), 0};
    const Sums here =
        gatherer_.at(face_, p, k == 0 ? candidates : std::span<const std::uint32_t>(met_), area * at.weight);
    if (k == 0) met_.assign(gatherer_.scratch.met.begin(), gatherer_.scratch.met.end());
    result.sums = result.sums + here;
    const double weight = k == 0 ? 1 - 3 * corner : k < 4 ? corner : 0;
    rough += here.light * (weight / at.weight);
  }
  result.error = std::abs(result.sums.light - rough);
  if (is_good(result, area) || depth >= deepest) return result;
  gatherer_.forget(mark);
  const moire::Point ab = middle(t.a, t.b), bc = middle(t.b, t.c), ca = middle(t.c, t.a);
  Integral sum;
  for (const Triangle& part :
       {Triangle{t.a, ab, ca}, Triangle{ab, t.b, bc}, Triangle{ca, bc, t.c}, Triangle{ab, bc, ca}}) {
    const Integral one = triangle(part, candidates, depth + 1);
    sum = {sum.sums + one.sums, sum.error + one.error};
  }
  return sum;
}

// At a contact, corner a: the angle is halved until halves agree with the whole.
Integral PieceIntegral::around(const Triangle& t, std::span<const std::uint32_t> candidates, int depth) {
  const double area = t.area();
  if (!(area > 0)) return {};
  const std::size_t start = gatherer_.mark();
  const Integral rough = collapsed(t, candidates);
  if (area < negligible) return rough;
  const std::size_t mark = gatherer_.mark();
  const moire::Point bc = middle(t.b, t.c);
  const Integral one = collapsed({t.a, t.b, bc}, candidates), other = collapsed({t.a, bc, t.c}, candidates);
  Integral sum{one.sums + other.sums, 0};
  sum.error = std::abs(sum.sums.light - rough.sums.light);
  if (is_good(sum, area) || depth >= deepest) {
    gatherer_.forget(start, mark);
    return sum;
  }
  gatherer_.forget(start);
  const Integral first = around({t.a, t.b, bc}, candidates, depth + 1);
  const Integral last = around({t.a, bc, t.c}, candidates, depth + 1);
  return {first.sums + last.sums, first.error + last.error};
}

// x = a + s ((1 - t) b + t c - a) takes the corner out of the integrand: Gauss-Jacobi of 2 points in s (for the weight
// s), Gauss of 4 points in t.
Integral PieceIntegral::collapsed(const Triangle& t, std::span<const std::uint32_t> candidates) {
  // (6 -+ sqrt 6) / 10 and, of twice the area, (9 -+ sqrt 6) / 36.
  constexpr std::array<double, 2> s{0.35505102572168218, 0.84494897427831783};
  constexpr std::array<double, 2> s_weight{2 * 0.18195861825602283, 2 * 0.31804138174397717};
  constexpr std::array<double, 4> angle{0.069431844202973714, 0.33000947820757187, 0.66999052179242813,
                                        0.93056815579702629};
  constexpr std::array<double, 4> angle_weight{0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                                               0.17392742256872693};
  const double area = t.area();
  Integral sum;
  for (std::size_t i = 0; i < angle.size(); ++i) {
    const moire::Point q{t.b.x + angle[i] * (t.c.x - t.b.x), t.b.y + angle[i] * (t.c.y - t.b.y)};
    for (std::size_t j = 0; j < s.size(); ++j) {
      const moire::Point p{t.a.x + s[j] * (q.x - t.a.x), t.a.y + s[j] * (q.y - t.a.y)};
      sum.sums = sum.sums + gatherer_.at(face_, p, candidates, area * angle_weight[i] * s_weight[j]);
    }
  }
  return sum;
}

}  // namespace shadow_planes
