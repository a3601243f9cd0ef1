#include "chords.h"

#include <algorithm>
#include <cmath>

namespace cartoon {

namespace {

using moire::Point;

// |p - 2 q + r|
double bend(Point p, Point q, Point r) { return std::hypot(p.x - 2 * q.x + r.x, p.y - 2 * q.y + r.y); }

// The larger half axis of c + u cos t + v sin t: the larger singular value of (u v).
double larger_axis(Point u, Point v) {
  return (std::hypot(u.x + v.y, u.y - v.x) + std::hypot(u.x - v.y, u.y + v.x)) / 2;
}

bool comes_before(Point p, Point q) { return p.x != q.x ? p.x < q.x : p.y < q.y; }

// Bernstein's form, p0 with weight 1 at t = 0.
Point quadratic(Point p0, Point p1, Point p2, double t) {
  const double s = 1 - t, a = s * s, b = 2 * s * t, c = t * t;
  return {a * p0.x + b * p1.x + c * p2.x, a * p0.y + b * p1.y + c * p2.y};
}
Point cubic(Point p0, Point p1, Point p2, Point p3, double t) {
  const double s = 1 - t, a = s * s * s, b = 3 * s * s * t, c = 3 * s * t * t, d = t * t * t;
  return {a * p0.x + b * p1.x + c * p2.x + d * p3.x, a * p0.y + b * p1.y + c * p2.y + d * p3.y};
}

double part(std::size_t k, std::size_t n) { return static_cast<double>(k) / static_cast<double>(n); }

}  // namespace

double chords_of(Verb verb, Point from, const Point* p, double tolerance) {
  double second_derivative = 0;
  switch (verb) {
    case Verb::move:
    case Verb::line:
      return 1;
    case Verb::quadratic:
      second_derivative = 2 * bend(from, p[0], p[1]);
      break;
    case Verb::cubic:
      second_derivative = 6 * std::max(bend(from, p[0], p[1]), bend(p[0], p[1], p[2]));
      break;
    case Verb::arc:
      second_derivative = (p[3].y - p[3].x) * (p[3].y - p[3].x) * larger_axis(p[1], p[2]);
      break;
  }
  const double count = std::ceil(std::sqrt(second_derivative / (8 * tolerance)));
  // An arc may be a whole turn, of which one chord or two would be nothing.
  const double least = verb == Verb::arc ? std::ceil(std::abs(p[3].y - p[3].x)) : 1;
  return std::max(count, least);
}

Point point_at(Verb verb, Point from, const Point* p, std::size_t k, std::size_t n) {
  if (verb == Verb::arc) {
    const double a = std::min(p[3].x, p[3].y), b = std::max(p[3].x, p[3].y);
    const double t = a + (b - a) * part(p[3].x <= p[3].y ? k : n - k, n);
    const double c = std::cos(t), s = std::sin(t);
    return {p[0].x + p[1].x * c + p[2].x * s, p[0].y + p[1].y * c + p[2].y * s};
  }
  const Point end = p[points_of(verb) - 1];
  bool backward = comes_before(end, from);
  if (verb == Verb::cubic && end == from) backward = comes_before(p[1], p[0]);
  if (verb == Verb::cubic) {
    return backward ? cubic(end, p[1], p[0], from, part(n - k, n)) : cubic(from, p[0], p[1], end, part(k, n));
  }
  return backward ? quadratic(end, p[0], from, part(n - k, n)) : quadratic(from, p[0], end, part(k, n));
}

}  // namespace cartoon
