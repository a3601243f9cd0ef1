#include "plugins/heightfield/paper.h"

#include <algorithm>
#include <cmath>

namespace moire::test {

PaperColumn::PaperColumn(const Map& map, const View& view, double x) : view_(view), z_(view.z) {
  const Ray middle = ray_through(view, x, view.size.height / 2.0);
  const double ground = std::hypot(middle.x, middle.y);
  const double east = middle.x / ground, south = middle.y / ground;  // world units a unit of way

  const Ray first = ray_through(view, x, 0), second = ray_through(view, x, 1);
  const auto advance = [&](Ray ray) { return ray.x * east + ray.y * south; };
  rise_ = first.z;
  rise_per_row_ = second.z - first.z;
  advance_ = advance(first);
  advance_per_row_ = advance(second) - advance_;

  // x_k: where the column crosses the grid lines across its major axis; the eye itself stands in the first voxel.
  const double columns = east / view.spacing_x, rows = south / view.spacing_y;  // voxels a unit of way
  const bool along_rows = std::abs(rows) > std::abs(columns);
  const double speed = along_rows ? rows : columns, drift = along_rows ? columns : rows;
  const double eye = along_rows ? view.y / view.spacing_y : view.x / view.spacing_x;
  const double other_eye = along_rows ? view.x / view.spacing_x : view.y / view.spacing_y;
  const int forth = speed < 0 ? -1 : 1;
  auto step = static_cast<std::int64_t>(forth > 0 ? std::floor(eye) : std::ceil(eye) - 1);
  for (;; step += forth) {
    const double line = static_cast<double>(forth > 0 ? step : step + 1);
    const double way = std::max((line - eye) / speed, 0.0);
    if (way >= view.far) break;
    const double other = other_eye + way * drift;
    const auto beside = static_cast<std::int64_t>(std::floor(other));
    const std::int64_t i = along_rows ? beside : step, j = along_rows ? step : beside;
    const double place = way > 0 ? line : eye;
    walls_.push_back({texel_element(0, i, j), way, map.height(i, j), along_rows ? other : place,
                      along_rows ? place : other, along_rows});
  }
}

double PaperColumn::slope(double y) const { return (rise_ + y * rise_per_row_) / (advance_ + y * advance_per_row_); }

double PaperColumn::row(double slope) const {
  return (slope * advance_ - rise_) / (rise_per_row_ - slope * advance_per_row_);
}

const Wall* PaperColumn::seen_at(double y) const {
  const double s = slope(y);
  for (const Wall& wall : walls_) {
    if (wall.height > z_ + wall.x * s) return &wall;
  }
  return nullptr;
}

std::vector<PaperColumn::Part> PaperColumn::seen_between(double low, double high) const {
  double lower = slope(low);
  const double upper = slope(high);
  std::vector<Part> parts;
  for (const Wall& wall : walls_) {
    const double ray = z_ + wall.x * lower, limit = z_ + wall.x * upper;
    if (!(wall.height > ray)) continue;
    const bool is_done = wall.height >= limit;
    const double reached = is_done ? upper : (wall.height - z_) / wall.x;
    const double from = row(lower), to = is_done ? high : row(reached);
    parts.push_back({&wall, std::min(wall.height, limit) - ray, from - to});
    lower = reached;
    if (is_done) break;
  }
  return parts;
}

std::map<Element, double> interpolated(const Wall& wall) {
  const TexelIndex at = texel_index(wall.element);
  const double y = (wall.across_east ? wall.s : wall.t) - 0.5;
  const auto first = static_cast<std::int64_t>(std::floor(y));
  const double share = y - static_cast<double>(first);
  const auto voxel = [&](std::int64_t k) {
    return wall.across_east ? texel_element(0, k, at.j) : texel_element(0, at.i, k);
  };
  return {{voxel(first), 1 - share}, {voxel(first + 1), share}};
}

}  // namespace moire::test
