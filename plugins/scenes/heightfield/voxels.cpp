#include "voxels.h"

#include <algorithm>
#include <cmath>

namespace heightfield {

namespace {

// At least this many steps between two divisions of a walk, however small the map.
constexpr int shortest_lap = 256;

std::vector<std::int32_t> wrapped_places(int size, int stride) {
  std::vector<std::int32_t> places(static_cast<std::size_t>(2 * size + std::max(2 * size, shortest_lap) + steps_ahead));
  for (std::size_t k = 0; k < places.size(); ++k) {
    places[k] =
        static_cast<std::int32_t>(moire::wrapped(static_cast<std::int64_t>(k), size, moire::Wrap::mirror) * stride);
  }
  return places;
}

Voxels::Level finest(const Terrain& terrain) {
  Voxels::Level level{terrain.width, terrain.height, {}, {}, {}, {}};
  level.cells.resize(terrain.heights.size());
  for (std::size_t k = 0; k < level.cells.size(); ++k) {
    const moire::Color c = terrain.colors[k];
    level.cells[k] = {terrain.heights[k], {c.r, c.g, c.b}};
  }
  return level;
}

// Each cell the mean of four.
Voxels::Level coarser(const Voxels::Level& fine) {
  Voxels::Level level{fine.width / 2, fine.height / 2, {}, {}, {}, {}};
  level.cells.resize(static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height));
  for (int j = 0; j < level.height; ++j) {
    for (int i = 0; i < level.width; ++i) {
      const Cell* a = &fine.cells[static_cast<std::size_t>(2 * j) * static_cast<std::size_t>(fine.width) +
                                  static_cast<std::size_t>(2 * i)];
      const Cell* b = a + fine.width;
      Cell& mean =
          level
              .cells[static_cast<std::size_t>(j) * static_cast<std::size_t>(level.width) + static_cast<std::size_t>(i)];
      mean.height = (a[0].height + a[1].height + b[0].height + b[1].height) / 4;
      for (int c = 0; c < 3; ++c) mean.rgb[c] = (a[0].rgb[c] + a[1].rgb[c] + b[0].rgb[c] + b[1].rgb[c]) / 4;
    }
  }
  return level;
}

}  // namespace

Voxels::Voxels(const Terrain& terrain) {
  const auto [low, high] = std::minmax_element(terrain.heights.begin(), terrain.heights.end());
  lowest_ = *low;
  highest_ = *high;
  double sum = 0;
  for (float h : terrain.heights) sum += h;
  mean_height_ = sum / static_cast<double>(terrain.heights.size());
  colors_are_finite_ = std::all_of(terrain.colors.begin(), terrain.colors.end(), [](moire::Color c) {
    return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b);
  });

  levels_.push_back(finest(terrain));
  while (levels_.back().width % 2 == 0 && levels_.back().height % 2 == 0) levels_.push_back(coarser(levels_.back()));
  for (Level& level : levels_) {
    level.columns = wrapped_places(level.width, 1);
    level.rows = wrapped_places(level.height, level.width);
    level.summits = Summits(level.cells, level.width, level.height);
  }
}

moire::Texture Voxels::texture() const {
  std::vector<moire::Texture::Level> levels;
  for (const Level& level : levels_) {
    levels.push_back({level.cells.front().rgb, sizeof(Cell) / sizeof(float), level.width, level.height});
  }
  return {std::move(levels), moire::Wrap::mirror};
}

}  // namespace heightfield
