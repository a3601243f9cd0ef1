#include "plugins/heightfield/small_terrain.h"

#include <moire/image.h>
#include <moire/random.h>

namespace moire::test {

namespace {

// Place of a mirrored index: forth and back again.
std::int64_t folded(std::int64_t index, std::int64_t size) {
  const std::int64_t lap = index >= 0 ? index / size : -((-index - 1) / size) - 1;
  const std::int64_t rest = index - lap * size;
  return lap % 2 == 0 ? rest : size - 1 - rest;
}

std::vector<Color> distinct_colors(int columns, int rows) {
  std::vector<Color> colors;
  const auto count = static_cast<float>(columns * rows);
  for (int k = 0; k < columns * rows; ++k) {
    const auto hue = static_cast<float>(random({.x = k}, 0, 7));
    colors.push_back({(static_cast<float>(k) + 0.5F) / count, hue, 1 - 0.5F * hue});
  }
  return colors;
}

}  // namespace

std::size_t Map::place(std::int64_t i, std::int64_t j) const {
  return static_cast<std::size_t>(folded(j, rows) * columns + folded(i, columns));
}

Map rough_map(int columns, int rows, double relief, std::uint64_t seed) {
  Map map{columns, rows, {}, distinct_colors(columns, rows)};
  for (int k = 0; k < columns * rows; ++k) {
    map.heights.push_back(static_cast<float>(relief * random({.x = k, .seed = seed}, 0, 0)));
  }
  return map;
}

Map flat_map(int columns, int rows, float height) {
  return {columns, rows, std::vector<float>(static_cast<std::size_t>(columns * rows), height),
          distinct_colors(columns, rows)};
}

Changes settings_of(const View& view) {
  return {{"far", view.far},          {"view.x", view.x},          {"view.y", view.y},
          {"view.height", view.z},    {"view.yaw_deg", view.yaw},  {"view.pitch_deg", view.pitch},
          {"view.fov_deg", view.fov}, {"spacing", view.spacing_x}, {"spacing_y", view.spacing_y}};
}

SmallTerrain::SmallTerrain(const Map& map, double spacing_x, double spacing_y, const Changes& made_with) {
  const ScenePlugin& plugin = scene_plugin("heightfield");
  std::vector<Color> heights;
  for (const float height : map.heights) heights.push_back({height, 0, 0});
  const auto height_file = folder_.path() / "height.exr", color_file = folder_.path() / "color.exr";
  write_image(height_file, map.columns, map.rows, heights, Depth::full);
  write_image(color_file, map.columns, map.rows, map.colors, Depth::full);
  settings_ = changed(plugin.parameters, made_with);
  settings_.set("height", height_file.string());
  settings_.set("color", color_file.string());
  settings_.set("spacing", spacing_x);
  settings_.set("spacing_y", spacing_y);
  scene_ = plugin.make(settings_);
}

std::unique_ptr<Frame> SmallTerrain::frame(const View& view, const Changes& changes) const {
  Settings settings = settings_;
  for (const Changes& some : {settings_of(view), changes}) {
    for (const auto& [name, value] : some) settings.set(name, value);
  }
  return scene_->frame(settings, view.size);
}

}  // namespace moire::test
