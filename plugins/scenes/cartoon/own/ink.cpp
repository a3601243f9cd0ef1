#include "ink.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "drawing/chords.h"
#include "reading/path_data.h"

namespace cartoon {

namespace {

using moire::Point;

Point middle(Point p, Point q) { return {(p.x + q.x) / 2, (p.y + q.y) / 2}; }

// Half as wide as the line, at a part of its length.
double half_width(double width, double part) {
  return width / 2 * std::sqrt(std::max(std::sin(std::numbers::pi * part), 0.0));
}

// The place beside line[k], at this distance to its right.
Point beside(const std::vector<Point>& line, std::size_t k, double distance, bool closed) {
  const std::size_t last = line.size() - 1;
  const Point before = line[k > 0 ? k - 1 : closed ? last - 1 : 0], after = line[k < last ? k + 1 : closed ? 1 : last];
  const double dx = after.x - before.x, dy = after.y - before.y, length = std::hypot(dx, dy);
  return {line[k].x - dy / length * distance, line[k].y + dx / length * distance};
}

// A smooth curve with these control points (a uniform quadratic B-spline), to its last one.
void follow(const std::vector<Point>& controls, Pen& pen) {
  for (std::size_t k = 0; k + 1 < controls.size(); ++k) {
    pen.quadratic_to(controls[k], middle(controls[k], controls[k + 1]));
  }
  pen.line_to(controls.back());
}

void draw_closed(const std::vector<Point>& line, double width, Pen& pen) {
  for (const double side : {width / 2, -width / 2}) {
    std::vector<Point> controls;
    for (std::size_t k = 0; k + 1 < line.size(); ++k) controls.push_back(beside(line, k, side, true));
    // One goes round as the line does, the other one against it, so that the inside stays empty.
    if (side < 0) std::ranges::reverse(controls);
    const Point start = middle(controls.back(), controls.front());
    controls.push_back(start);
    pen.move_to(start);
    follow(controls, pen);
    pen.close();
  }
}

void draw_tapered(const std::vector<Point>& line, double width, Pen& pen) {
  std::vector<Point> there, back;
  for (std::size_t k = 1; k + 1 < line.size(); ++k) {
    const double half = half_width(width, static_cast<double>(k) / static_cast<double>(line.size() - 1));
    there.push_back(beside(line, k, half, false));
    back.insert(back.begin(), beside(line, k, -half, false));
  }
  there.push_back(line.back());
  back.push_back(line.front());
  pen.move_to(line.front());
  follow(there, pen);
  follow(back, pen);
  pen.close();
}

void draw_line(const std::vector<Point>& line, double width, Pen& pen) {
  if (line.size() < 3) return;
  line.front() == line.back() ? draw_closed(line, width, pen) : draw_tapered(line, width, pen);
}

}  // namespace

void draw_ink(std::string_view data, double width, Pen& pen) {
  constexpr std::size_t pieces = 12;  // of each part of the path
  Drawing drawing;
  Pen pencil(drawing);
  draw_path_data(data, pencil);
  std::vector<Point> line;
  const Point* p = drawing.points.data();
  for (const Verb verb : drawing.verbs) {
    if (verb == Verb::move) {
      draw_line(line, width, pen);
      line.clear();
      line.push_back(p[0]);
    } else if (verb == Verb::line) {
      const Point from = line.back();
      for (std::size_t k = 1; k <= pieces; ++k) {
        const double t = static_cast<double>(k) / pieces;
        line.push_back(k == pieces ? p[0] : Point{from.x + (p[0].x - from.x) * t, from.y + (p[0].y - from.y) * t});
      }
    } else {
      put_chords(verb, line.back(), p, pieces, [&line](Point q) { line.push_back(q); });
    }
    p += points_of(verb);
  }
  draw_line(line, width, pen);
}

}  // namespace cartoon
