#include "world/faces.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "world/convex_parts.h"

namespace shadow_planes {

namespace {

// Of areas, by the square of the polygon's size: below it there is no normal to speak of.
constexpr double least_area = 1e-14;
// Of distances, by the polygon's size.
constexpr double flat_enough = 1e-9;

double size_of(std::span<const Vector> corners) {
  double size = 0;
  for (const Vector& p : corners) size = std::max(size, length(p - corners[0]));
  return size;
}

// Newell's: twice the area in the normal's direction.
Vector area_vector(std::span<const Vector> corners) {
  Vector sum;
  for (std::size_t k = 2; k < corners.size(); ++k)
    sum = sum + cross(corners[k - 1] - corners[0], corners[k] - corners[0]);
  return sum;
}

bool has_area(std::span<const Vector> corners) {
  const double size = size_of(corners);
  return length(area_vector(corners)) > least_area * size * size;
}

// Requires: has_area().
Plane plane_of(std::span<const Vector> corners) {
  const Vector area = area_vector(corners);
  const Vector normal = (1 / length(area)) * area;
  Vector sum;
  for (const Vector& p : corners) sum = sum + p;
  return {normal, -dot(normal, (1 / static_cast<double>(corners.size())) * sum)};
}

// Without the coordinate along which the plane is steepest; counterclockwise.
std::vector<moire::Point> flattened(std::span<const Vector> corners, const Vector& normal) {
  const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
  std::vector<moire::Point> points;
  for (const Vector& p : corners) {
    if (z >= x && z >= y) {
      points.push_back(normal.z > 0 ? moire::Point{p.x, p.y} : moire::Point{p.y, p.x});
    } else if (x >= y) {
      points.push_back(normal.x > 0 ? moire::Point{p.y, p.z} : moire::Point{p.z, p.y});
    } else {
      points.push_back(normal.y > 0 ? moire::Point{p.z, p.x} : moire::Point{p.x, p.z});
    }
  }
  return points;
}

}  // namespace

std::string problem_of(std::span<const Vector> corners) {
  if (corners.size() < 3) return fmt::format("is no polygon ({} corners); 3 or more make one", corners.size());
  if (!has_area(corners)) {
    const double size = size_of(corners);
    for (const Vector& p : corners) {
      for (const Vector& q : corners) {
        if (length(cross(p - corners[0], q - corners[0])) > 2 * least_area * size * size)
          return "crosses itself (its areas cancel); a simple polygon goes round once";
      }
    }
    return {};
  }
  const Plane plane = plane_of(corners);
  double off = 0;
  for (const Vector& p : corners) off = std::max(off, std::abs(plane.distance(p)));
  if (off > flat_enough * size_of(corners))
    return fmt::format("is not flat (a corner is {:.3g} off its plane); {:.3g} at most is", off,
                       flat_enough * size_of(corners));
  if (const auto crossing = first_crossing(flattened(corners, plane.normal)))
    return fmt::format("crosses itself (sides from corners {} and {}); a simple polygon does not", crossing->first,
                       crossing->second);
  return {};
}

Face face_of(std::span<const Vector> corners) {
  Face face;
  if (!has_area(corners)) return face;
  face.plane = plane_of(corners);
  for (const std::vector<std::size_t>& part : convex_parts(flattened(corners, face.plane.normal))) {
    Convex& convex = face.parts.emplace_back();
    for (const std::size_t corner : part) convex.push_back(corners[corner]);
  }
  return face;
}

Vector middle_of(const std::vector<Convex>& parts) {
  const Vector origin = parts[0][0];
  double area = 0;
  Vector sum;
  for (const Convex& part : parts) {
    for (std::size_t k = 2; k < part.size(); ++k) {
      const double triangle = length(cross(part[k - 1] - part[0], part[k] - part[0]));
      area += triangle;
      sum = sum + (triangle / 3) * ((part[0] - origin) + (part[k - 1] - origin) + (part[k] - origin));
    }
  }
  return origin + (1 / area) * sum;
}

void share_planes(std::vector<Face>& faces) {
  double scale = 0;
  for (const Face& face : faces) {
    for (const Convex& part : face.parts) {
      for (const Vector& p : part) scale = std::max({scale, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
  }
  const double tolerance = 1e-12 * scale;
  for (std::size_t k = 0; k < faces.size(); ++k) {
    for (std::size_t j = 0; j < k; ++j) {
      const Plane& plane = faces[j].plane;
      const double turned = dot(plane.normal, faces[k].plane.normal);
      const auto is_within = [&](const Convex& part) {
        return std::all_of(part.begin(), part.end(),
                           [&](const Vector& p) { return std::abs(plane.distance(p)) <= tolerance; });
      };
      if (faces[j].parts.empty() || std::abs(turned) < 0.5 ||
          !std::all_of(faces[k].parts.begin(), faces[k].parts.end(), is_within))
        continue;
      faces[k].plane = turned > 0 ? plane : Plane{-plane.normal, -plane.d};
      break;
    }
  }
}

}  // namespace shadow_planes
