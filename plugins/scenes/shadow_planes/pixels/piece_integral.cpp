#include "pixels/piece_integral.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "light/triangle_rule.h"
#include "pixels/outline_moments.h"

namespace shadow_planes {

namespace {

// Divisions of a triangle, and of an angle at a contact.
constexpr int deepest = 8;
// Pieces of less than this part of a pixel are as good as their middle.
constexpr double negligible = 1e-8;

// Where edges that cross pass behind another, on a curve, the function bends: estimates that look for smooth terms see
// too little of that.
constexpr double bent = 4, bent_triangle = 16;

double size_of(moire::Point p) { return std::sqrt(p.x * p.x + p.y * p.y); }

// From one term of a series to the next: 1 if it does not fall.
double fall_of(double from, double to) { return to < from ? to / from : from == 0 && to == 0 ? 0.0 : 1.0; }

moire::Point middle(moire::Point p, moire::Point q) { return {0.5 * (p.x + q.x), 0.5 * (p.y + q.y)}; }

// Angles of points at equal distances on a circle, as their cosines and sines and those of twice and three times them.
struct Direction {
  double cos1, sin1, cos2, sin2, cos3, sin3;
};

template <std::size_t count>
const std::array<Direction, count>& directions(double first) {
  static const std::array<Direction, count> all = [first] {
    std::array<Direction, count> made;
    for (std::size_t k = 0; k < count; ++k) {
      const double angle = first + 2 * std::numbers::pi * static_cast<double>(k) / count;
      made[k] = {std::cos(angle),     std::sin(angle),     std::cos(2 * angle),
                 std::sin(2 * angle), std::cos(3 * angle), std::sin(3 * angle)};
    }
    return made;
  }();
  return all;
}

}  // namespace

double PieceIntegral::Triangle::area() const { return 0.5 * ((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y)); }

bool PieceIntegral::is_good(const Integral& integral, double area) const {
  // Small pieces may err more by area: there are few of them.
  return integral.error <= tolerance_ * std::max(area, 0.05);
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
  const Integral rough = whole(outline, candidates);
  if (is_good(rough, area)) return rough;
  gatherer_.forget(mark);
  Integral sum;
  for (std::size_t k = 2; k < outline.size(); ++k) {
    const Integral part = triangle({outline[0], outline[k - 1], outline[k]}, candidates, 1);
    sum = {sum.sums + part.sums, sum.error + part.error};
  }
  return sum;
}

// Exact for polynomials of degree 3 over any convex outline.
//
// Seven points on the ellipse sqrt 2 times that of inertia, which lies within the outline (Kannan, Lovasz, Simonovits
// 1995, "Isoperimetric problems for convex bodies and a localization lemma", theorem 4.1): their mean is right to
// degree 2. In the coordinates that make the ellipse a circle, third order is r^3 times the cosine and sine of the
// angle and of three times it. The seven see the latter, and correct the mean by the outline's moments. The former need
// three points further in, asked for only where they may matter.
Integral PieceIntegral::whole(const Outline& outline, std::span<const std::uint32_t> candidates) {
  const OutlineMoments m = moments_of(outline);
  if (m.area < negligible) return {gatherer_.at(face_, m.centroid, candidates, m.area), 0};
  constexpr double root_2 = 1.4142135623730951, cube = 2 * root_2, inner = 0.6;
  // Not along a side of common outlines, so that no point of a triangle is on an edge.
  const auto& outer_ring = directions<7>(0.3);
  const auto& inner_ring = directions<3>(0);
  const std::size_t mark = gatherer_.mark();
  std::array<Sums, 11> values;
  std::array<double, 11> weight{};
  std::size_t count = 0;
  bool overlap = false;
  const auto ask = [&](double u, double v) {
    values[count] = gatherer_.at(face_, m.at(u, v), count == 0 ? candidates : std::span<const std::uint32_t>(met_), 1);
    if (count == 0) met_.assign(gatherer_.scratch.met.begin(), gatherer_.scratch.met.end());
    overlap |= gatherer_.scratch.overlap;
    return values[count++].light;
  };
  moire::Point first, second, third_order;
  double sum = 0, correction = 0;
  for (std::size_t k = 0; k < 7; ++k) {
    const Direction& d = outer_ring[k];
    const double light = ask(root_2 * d.cos1, root_2 * d.sin1), value = 2.0 / 7 * light;
    sum += light;
    first.x += d.cos1 * value, first.y += d.sin1 * value;
    second.x += d.cos2 * value, second.y += d.sin2 * value;
    third_order.x += d.cos3 * value, third_order.y += d.sin3 * value;
    // The share of each point in the third harmonics of the outline.
    const double third = 2.0 / 7 / cube * (d.cos3 * m.cos3 + d.sin3 * m.sin3);
    correction += third * light;
    weight[k] = 1.0 / 7 + third;
  }
  const double a1 = size_of(first), a3 = size_of(third_order), odd = size_of({m.cos1, m.sin1});
  const auto is_enough = [&](double error) { return is_good({{}, m.area * error}, m.area); };
  // The fourth order by how the harmonics fall. One of them may be small by chance, and seven points see the fourth as
  // a third: the root of the fall keeps the estimate above the error there, and nothing counts as much less than what
  // the first two let expect of the next (of an exponential 2/3 and 1/5 of these).
  struct Estimate {
    double fourth, third;  // order; of the third, what was not asked for is as large as what was
    double sum() const { return fourth + third; }
  };
  const auto estimated = [&](double a2) {
    const double fall = fall_of(a1, a2), next = a2 * fall, after = next * fall;
    const double smooth = 2 * std::sqrt(std::max(fall, fall_of(a2, a3)));
    return Estimate{std::max((overlap ? bent : smooth) * a3, after / 20), odd * std::max(a3, next / 4) / cube};
  };
  const double a2 = size_of(second);
  Estimate estimate = estimated(a2);
  // The ring does not see a bend that is the same in all directions: if one that is plausible would matter, the middle
  // tells.
  if (const double plausible = a1 / 8; a2 < plausible && is_enough(estimate.fourth)) {
    if (!is_enough(estimated(plausible).sum())) {
      estimate = estimated(std::max(a2, std::abs(ask(0, 0) - sum / 7)));
    }
  }
  double error = estimate.sum();
  if (!is_enough(error) && is_enough(estimate.fourth)) {
    const double gap = 2 - inner * inner;
    double asked = 0;
    for (std::size_t k = 0; k < 7; ++k) {
      // Points further in see second harmonics as first ones; these have them to take away.
      const Direction& d = outer_ring[k];
      const double share =
          2.0 / 7 / gap *
          (m.cos1 * (d.cos1 / root_2 + d.cos2 * inner / 2) + m.sin1 * (d.sin1 / root_2 - d.sin2 * inner / 2));
      asked += share * values[k].light;
      weight[k] += share;
    }
    for (const Direction& d : inner_ring) {
      const double share = weight[count] = -2.0 / 3 / (inner * gap) * (m.cos1 * d.cos1 + m.sin1 * d.sin1);
      asked += share * ask(inner * d.cos1, inner * d.sin1);
    }
    error = estimate.fourth + (std::abs(correction) + std::abs(asked)) / 8;
  }
  Integral result{{}, m.area * error};
  for (std::size_t k = 0; k < count; ++k) result.sums = result.sums + (m.area * weight[k]) * values[k];
  gatherer_.weigh(mark, {weight.data(), count}, m.area);
  if (overlap && sum == 0) result.error = m.area * seen_in_corners(outline, m.centroid);
  return result;
}

// Behind several casters a little of the light may be seen beyond a curve although no point of a rule sees it: the most
// of it that points near the corners do.
double PieceIntegral::seen_in_corners(std::span<const moire::Point> corners, moire::Point inside) {
  constexpr double inward = 1.0 / 64;
  const std::size_t mark = gatherer_.mark();
  double most = 0;
  for (const moire::Point& p : corners) {
    const moire::Point near{p.x + inward * (inside.x - p.x), p.y + inward * (inside.y - p.y)};
    most = std::max(most, gatherer_.at(face_, near, met_, 1).light);
  }
  gatherer_.forget(mark);
  return most;
}

// Seven points, of degree 5, held against four of them, of degree 2: the middle and the corners of the inner triangle
// (positive weights, from the moments).
Integral PieceIntegral::triangle(const Triangle& t, std::span<const std::uint32_t> candidates, int depth) {
  const double area = t.area();
  if (!(area > 0)) return {};
  const std::size_t mark = gatherer_.mark();
  Integral result;
  double rough = 0;
  bool overlap = false;
  constexpr double near = 0.10128650732345634;
  constexpr double corner = (1.0 / 2 - 1.0 / 3) / (2 * near * near + (1 - 2 * near) * (1 - 2 * near) - 1.0 / 3) / 3;
  for (std::size_t k = 0; k < seven_points.size(); ++k) {
    const TrianglePoint& at = seven_points[k];
    const moire::Point p{at.a * t.a.x + at.b * t.b.x + at.c * t.c.x, at.a * t.a.y + at.b * t.b.y + at.c * t.c.y};
    if (area < negligible) return {gatherer_.at(face_, p, candidates, area), 0};
    const Sums here =
        gatherer_.at(face_, p, k == 0 ? candidates : std::span<const std::uint32_t>(met_), area * at.weight);
    if (k == 0) met_.assign(gatherer_.scratch.met.begin(), gatherer_.scratch.met.end());
    overlap |= gatherer_.scratch.overlap;
    result.sums = result.sums + here;
    const double weight = k == 0 ? 1 - 3 * corner : k < 4 ? corner : 0;
    rough += here.light * (weight / at.weight);
  }
  result.error = (overlap ? bent_triangle : 1) * std::abs(result.sums.light - rough);
  if (overlap && result.sums.light == 0) {
    result.error =
        area * seen_in_corners(std::array{t.a, t.b, t.c}, {(t.a.x + t.b.x + t.c.x) / 3, (t.a.y + t.b.y + t.c.y) / 3});
  }
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
