#include "pen.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include <moire/error.h>
#include <moire/turn.h>

namespace cartoon {

namespace {

using moire::Point;

void check(Point p) {
  for (const double value : {p.x, p.y}) {
    if (!(std::abs(value) <= largest_coordinate)) {
      throw moire::Error(
          fmt::format("reaches coordinate {:.6g}; at most {:g} can be drawn", value, largest_coordinate));
    }
  }
}

// The centre of an ellipse and the vectors to its ends, and the angles between which it is seen.
struct Arc {
  Point center, u, v;
  double a, b;
};

// SVG 1.1, F.6.5 and F.6.6, with lengths in place of squares, which would leave the range of numbers.
bool find_arc(Point from, Point to, double rx, double ry, double angle_deg, bool large, bool rising, Arc& arc) {
  const moire::Turn turning = moire::turn_of(angle_deg);
  const double hx = (from.x - to.x) / 2, hy = (from.y - to.y) / 2;
  double x = (turning.cosine * hx + turning.sine * hy) / rx, y = (turning.cosine * hy - turning.sine * hx) / ry;
  const double half = std::hypot(x, y);  // of the chord, where the ellipse is the unit circle
  if (!std::isfinite(half) || half == 0) return false;
  if (half > 1) rx *= half, ry *= half, x /= half, y /= half;
  const double chord = std::min(half, 1.0), away = std::sqrt((1 - chord) * (1 + chord)) / chord;
  const double side = large == rising ? -1 : 1;
  const double cx = side * away * y, cy = -side * away * x;
  arc.u = {rx * turning.cosine, rx * turning.sine};
  arc.v = {-ry * turning.sine, ry * turning.cosine};
  arc.center = {(from.x + to.x) / 2 + arc.u.x * cx + arc.v.x * cy, (from.y + to.y) / 2 + arc.u.y * cx + arc.v.y * cy};
  arc.a = std::atan2(y - cy, x - cx);
  arc.b = std::atan2(-y - cy, -x - cx);
  constexpr double turn = 2 * std::numbers::pi;
  if (rising && arc.b < arc.a) arc.b += turn;
  if (!rising && arc.b > arc.a) arc.b -= turn;
  return std::isfinite(arc.center.x) && std::isfinite(arc.center.y);
}

bool comes_before(Point p, Point q) { return p.x != q.x ? p.x < q.x : p.y < q.y; }

}  // namespace

void Pen::put(Point p) {
  check(p);
  const Point placed = transform_(p);
  check(placed);
  drawing_.points.push_back(placed);
}

void Pen::begin(Verb verb) {
  if (!open_) {
    drawing_.verbs.push_back(Verb::move);
    put(start_);
    open_ = true;
  }
  drawing_.verbs.push_back(verb);
}

void Pen::move_to(Point p) {
  check(p);
  at_ = start_ = p;
  open_ = false;
}

void Pen::line_to(Point p) {
  begin(Verb::line);
  put(p);
  at_ = p;
}

void Pen::quadratic_to(Point control, Point p) {
  begin(Verb::quadratic);
  put(control);
  put(p);
  at_ = p;
}

void Pen::cubic_to(Point control1, Point control2, Point p) {
  begin(Verb::cubic);
  put(control1);
  put(control2);
  put(p);
  at_ = p;
}

void Pen::arc_to(double rx, double ry, double angle_deg, bool large, bool rising, Point p) {
  rx = std::abs(rx), ry = std::abs(ry);
  check({rx, ry});
  check(p);
  if (!(std::abs(angle_deg) <= largest_coordinate)) {
    throw moire::Error(
        fmt::format("is turned by {:.6g} degrees; at most {:g} are taken", angle_deg, largest_coordinate));
  }
  if (p == at_) return;
  // Both ways along one arc must give the same bits, so that shapes that share it fit.
  const bool backward = comes_before(p, at_);
  Arc arc;
  const bool found = rx > 0 && ry > 0 &&
                     (backward ? find_arc(p, at_, rx, ry, angle_deg, large, !rising, arc)
                               : find_arc(at_, p, rx, ry, angle_deg, large, rising, arc));
  if (!found) return line_to(p);
  if (backward) std::swap(arc.a, arc.b);
  put_arc(arc.center, arc.u, arc.v, arc.a, arc.b, p);
}

void Pen::put_arc(Point center, Point u, Point v, double a, double b, Point end) {
  begin(Verb::arc);
  put(center);
  const auto put_vector = [this](Point d) {
    const Point turned{transform_.xx * d.x + transform_.xy * d.y, transform_.yx * d.x + transform_.yy * d.y};
    check(turned);
    drawing_.points.push_back(turned);
  };
  put_vector(u);
  put_vector(v);
  drawing_.points.push_back({a, b});
  put(end);
  at_ = end;
}

void Pen::close() {
  at_ = start_;
  open_ = false;
}

void Pen::ellipse(Point center, double rx, double ry) {
  move_to({center.x + rx, center.y});
  put_arc(center, {rx, 0}, {0, ry}, 0, 2 * std::numbers::pi, start_);
  close();
}

void Pen::finish(Rgb color, moire::FillRule rule) {
  open_ = false;
  drawing_.layers.push_back({first_verb_, first_point_, color, rule});
  first_verb_ = drawing_.verbs.size();
  first_point_ = drawing_.points.size();
}

void Pen::discard() {
  open_ = false;
  drawing_.verbs.resize(first_verb_);
  drawing_.points.resize(first_point_);
}

}  // namespace cartoon
