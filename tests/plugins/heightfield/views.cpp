#include "plugins/heightfield/views.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

namespace moire::test {

Map usual_map() { return rough_map(usual_columns, usual_rows, usual_relief); }

std::vector<View> views_all_round() {
  struct Place {
    double x, y;
  };
  constexpr std::array places{Place{3.3, 5.7}, Place{5, 3.4},          Place{2.6, 9},
                              Place{4, 7},     Place{-37.3, 10007.61}, Place{-2e6 - 0.75, 1e6 + 0.25}};
  constexpr std::array fields{35.0, 10.0, 100.0, 60.0};
  std::vector<View> views;
  for (const double pitch : {-70, -45, -20, -5, 0, 10, 20}) {
    for (const double yaw : {0.0, 20.0, 45.0, 90.0, 135.5, 180.0, 225.0, 270.0, 311.3}) {
      const std::size_t k = views.size();
      View view;
      view.x = places[k % places.size()].x;
      view.y = places[k % places.size()].y;
      view.z = 9 + static_cast<double>(k % 5) * 2.1;
      view.yaw = yaw;
      view.pitch = pitch;
      view.fov = fields[k % fields.size()];
      view.size = {23 + static_cast<int>(k % 2), 17 + static_cast<int>(k / 2 % 2)};
      view.caption =
          fmt::format("pitch {}, yaw {}, fov {}, eye ({}, {}, {})", pitch, yaw, view.fov, view.x, view.y, view.z);
      view.on_edges = yaw == 45 * std::round(yaw / 45) ? view.size.width + view.size.height : 0;
      views.push_back(view);
    }
  }
  return views;
}

std::vector<View> awkward_views(const Map& map) {
  constexpr ImageSize size{25, 19};
  constexpr int all = size.width * size.height;
  std::vector<View> views;
  const auto add = [&](std::string caption, double x, double y, double z, double yaw, double pitch, double fov = 60,
                       double far = 40) -> View& {
    const bool is_aligned = yaw == 45 * std::round(yaw / 45);
    views.push_back({.caption = std::move(caption),
                     .x = x,
                     .y = y,
                     .z = z,
                     .yaw = yaw,
                     .pitch = pitch,
                     .fov = fov,
                     .far = far,
                     .size = size,
                     .on_edges = is_aligned ? 2 * (size.width + size.height) : 0});
    return views.back();
  };
  const auto ground = [&](double x, double y) -> double {
    return map.height(static_cast<std::int64_t>(std::floor(x)), static_cast<std::int64_t>(std::floor(y)));
  };
  for (const double yaw : {0.0, 77.0, 200.0, 300.0}) {
    const double x = 6.3 + yaw, y = 2.8 - yaw;
    add("just above the ground, among the hills, level", x, y, ground(x, y) + 0.0513, yaw, 0, 100);
    add("just above the ground, looking down", x, y, ground(x, y) + 0.0513, yaw, -40);
    add("just above the ground, looking up", x, y, ground(x, y) + 0.3, yaw, 40, 90);
    add("within the ground", x, y, ground(x, y) - 0.5, yaw, 5);
    add("on the ground to the bit", x, y, ground(x, y), yaw, -10).on_edges = all;
    add("straight up out of a hole", x, y, ground(x, y) + 0.1, yaw, 90, 120);
    add("straight down", x, y, 15, yaw, -90);
    add("straight down, near, wide", x + 0.25, y + 0.25, 9, yaw, -90, 130);
    add("the nadir in the picture", x, y, 15, yaw, -85);
    add("the nadir at its lower edge", x, y, 15, yaw, -70);
    add("a far limit within a voxel", x, y, 8.5, yaw, -60, 100, 0.3);
    add("a far limit of a few voxels", x, y, 12, yaw, -45, 100, 3.7);
    add("a long far limit, grazing", x, y, 8.2, yaw, -2, 20, 250);
    add("nothing but sky", x, y, 9, yaw, 60, 30);
    add("as wide as can be", x, y, 11, yaw, -30, 170);
    add("as narrow as can be", x, y, 11, yaw, -30, 0.01);
    add("a far limit of zero", x, y, ground(x, y) - 1, yaw, -60, 60, 0).on_edges = all;
  }
  for (const double yaw : {0.0, 90.0, 180.0, 270.0, -90.0, 45.0, 135.0}) {
    add("on a vertex", 4, 7, 10, yaw, -30);
    add("on a grid line", 4, 7.5, 10, yaw, -30);
    add("on the other grid line", 4.5, 7, 10, yaw, -30);
    add("on the map's border", 0, 0, 10, yaw, -10, 90);
    add("on the mirrored border", map.columns, -map.rows, 10, yaw, -50);
  }
  return views;
}

std::vector<View> all_views(const Map& map) {
  std::vector<View> views = views_all_round();
  const std::vector<View> awkward = awkward_views(map);
  views.insert(views.end(), awkward.begin(), awkward.end());
  return views;
}

}  // namespace moire::test
