// Small maps, cameras above them, and the scene `heightfield` made of both.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "support/plugins.h"
#include "temporary_folder.h"

namespace moire::test {

// Heights and colours of a map, mirrored to infinity.
struct Map {
  int columns = 0, rows = 0;
  std::vector<float> heights;  // rows follow each other
  std::vector<Color> colors;

  std::size_t place(std::int64_t i, std::int64_t j) const;
  float height(std::int64_t i, std::int64_t j) const { return heights[place(i, j)]; }
  Color color(std::int64_t i, std::int64_t j) const { return colors[place(i, j)]; }
};

// Heights without pattern between 0 and `relief`; every voxel has a colour of its own.
Map rough_map(int columns, int rows, double relief, std::uint64_t seed = 1);
// The same heights everywhere.
Map flat_map(int columns, int rows, float height = 0);

// A camera, in the units of the scene's parameters.
struct View {
  std::string caption;
  double x = 0, y = 0, z = 0;
  double yaw = 0, pitch = 0, fov = 50;
  double far = 40;
  double spacing_x = 1, spacing_y = 1;
  ImageSize size{24, 18};
  int on_edges = 0;  // so many pixels at most see an edge, to 1e-9: more than none where the view is tied to the grid
};

// The scene's settings for a view.
Changes settings_of(const View& view);

// A scene made of a map through files, as the program does it.
class SmallTerrain {
 public:
  // `made_with`: settings that are not per frame; spacings are taken from a view.
  explicit SmallTerrain(const Map& map, double spacing_x = 1, double spacing_y = 1, const Changes& made_with = {});

  std::unique_ptr<Frame> frame(const View& view, const Changes& changes = {}) const;

 private:
  TemporaryFolder folder_;
  Settings settings_;
  std::unique_ptr<Scene> scene_;
};

}  // namespace moire::test
