#include "plugins/heightfield/box_clipper.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "plugins/heightfield/brute_force.h"
#include "support/pieces.h"

namespace moire::test {

namespace {

using Face = std::vector<Ray>;  // corners, seen from the eye

// Of a box around the eye's axes, without bottom: its top and the walls that face the eye.
std::vector<Face> faces_of(double x0, double x1, double y0, double y1, double top, double bottom) {
  std::vector<Face> faces{{{x0, y0, top}, {x1, y0, top}, {x1, y1, top}, {x0, y1, top}}};
  const auto wall = [&](double ax, double ay, double bx, double by) {
    faces.push_back({{ax, ay, top}, {bx, by, top}, {bx, by, bottom}, {ax, ay, bottom}});
  };
  if (x0 > 0) wall(x0, y0, x0, y1);
  if (x1 < 0) wall(x1, y0, x1, y1);
  if (y0 > 0) wall(x0, y0, x1, y0);
  if (y1 < 0) wall(x0, y1, x1, y1);
  return faces;
}

// The image of the part of a face in front of the eye.
Outline image_of_face(const View& view, const Face& face) {
  const Ray ahead = ray_through(view, view.size.width / 2.0, view.size.height / 2.0);
  const auto depth = [&](const Ray& r) { return r.x * ahead.x + r.y * ahead.y + r.z * ahead.z - 1e-3; };
  Outline outline;
  for (std::size_t k = 0; k < face.size(); ++k) {
    const Ray &a = face[k], &b = face[(k + 1) % face.size()];
    const double da = depth(a), db = depth(b);
    if (da >= 0) outline.push_back(image_of(view, a));
    if ((da < 0) == (db < 0)) continue;
    const double t = da / (da - db);
    outline.push_back(image_of(view, {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)}));
  }
  if (area_of(outline) < 0) std::reverse(outline.begin(), outline.end());
  return outline;
}

// Cuts a convex outline out of convex pieces; returns the area taken away.
double cut_out(const Outline& outline, std::vector<Outline>& pieces) {
  double taken = 0;
  std::vector<Outline> left;
  for (Outline piece : pieces) {
    for (std::size_t k = 0; k < outline.size() && !piece.empty(); ++k) {
      const Point a = outline[k], b = outline[(k + 1) % outline.size()];
      const auto inward = [&](Point p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); };
      Outline outside = part_of(piece, [&](Point p) { return -inward(p); });
      if (outside.size() > 2) left.push_back(std::move(outside));
      piece = part_of(piece, inward);
    }
    if (piece.size() > 2) taken += area_of(piece);
  }
  std::erase_if(left, [](const Outline& piece) { return area_of(piece) < 1e-13; });
  pieces = std::move(left);
  return taken;
}

}  // namespace

std::map<Element, double> box_areas(const Map& map, const View& view, int x, int y) {
  const auto eye_i = static_cast<std::int64_t>(std::floor(view.x / view.spacing_x));
  const auto eye_j = static_cast<std::int64_t>(std::floor(view.y / view.spacing_y));
  const double lowest = *std::min_element(map.heights.begin(), map.heights.end());
  const auto reach = static_cast<std::int64_t>(view.far / std::min(view.spacing_x, view.spacing_y));

  const double left = x, top = y;
  std::vector<Outline> pieces{{{left, top}, {left + 1, top}, {left + 1, top + 1}, {left, top + 1}}};
  std::map<Element, double> areas;
  // No box hides one that is fewer steps over borders away.
  for (std::int64_t steps = 0; steps <= 2 * reach && !pieces.empty(); ++steps) {
    for (std::int64_t di = -steps; di <= steps; ++di) {
      for (const std::int64_t side : {steps - std::abs(di), std::abs(di) - steps}) {
        if (side == 0 && steps > std::abs(di)) continue;
        const std::int64_t i = eye_i + di, j = eye_j + side;
        const double x0 = static_cast<double>(i) * view.spacing_x - view.x;
        const double y0 = static_cast<double>(j) * view.spacing_y - view.y;
        for (const Face& face : faces_of(x0, x0 + view.spacing_x, y0, y0 + view.spacing_y, map.height(i, j) - view.z,
                                         lowest - 1 - view.z)) {
          const Outline outline = image_of_face(view, face);
          if (outline.size() < 3) continue;
          const double area = cut_out(outline, pieces);
          if (area > 0) areas[texel_element(0, i, j)] += area;
        }
        if (side == 0) break;
      }
    }
  }
  return areas;
}

}  // namespace moire::test
