#include "world/light_points.h"

#include <algorithm>

namespace shadow_planes {

LightPoints::LightPoints(const Light& light) {
  only_ = {light.place.x, light.place.y, light.place.z, light.kind == LightKind::directional ? 0.0 : 1.0};
  if (light.kind != LightKind::area) return;
  const auto add = [&](const Vector& from, const Vector& first, const Vector& second, bool is_parallelogram) {
    area_ += (is_parallelogram ? 1 : 0.5) * length(cross(first, second));
    pieces_.push_back({from, first, second, is_parallelogram, area_});
  };
  for (const Convex& part : light.parts) {
    const Vector off = part.size() == 4 ? part[0] + part[2] - part[1] - part[3] : Vector{};
    if (part.size() == 4 && length(off) <= 1e-12 * (length(part[2] - part[0]) + length(part[3] - part[1]))) {
      add(part[0], part[1] - part[0], part[3] - part[0], true);
    } else {
      for (std::size_t k = 2; k < part.size(); ++k) add(part[0], part[k - 1] - part[0], part[k] - part[0], false);
    }
  }
  for (Piece& piece : pieces_) piece.end /= area_;
}

Homogeneous LightPoints::at(double u, double v) const {
  if (pieces_.empty()) return only_;
  const auto piece = std::find_if(pieces_.begin(), pieces_.end() - 1, [&](const Piece& p) { return u < p.end; });
  const double begin = piece == pieces_.begin() ? 0 : (piece - 1)->end;
  const double along = pieces_.size() == 1 ? u : (u - begin) / (piece->end - begin);
  Vector p;
  if (piece->is_parallelogram) {
    p = piece->from + along * piece->first + v * piece->second;
  } else {
    p = piece->from + std::sqrt(v) * (piece->first + along * (piece->second - piece->first));
  }
  return {p.x, p.y, p.z, 1};
}

}  // namespace shadow_planes
