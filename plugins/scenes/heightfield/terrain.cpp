#include "terrain.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <moire/error.h>
#include <moire/image.h>

#include "fractal/fractal.h"

namespace heightfield {

namespace {

// What each of `parts` equal parts of `size` pixels is made of: pixels and their share, which sum to 1.
struct Part {
  int first;
  std::vector<double> shares;
};

std::vector<Part> parts_of(int size, int parts) {
  std::vector<Part> result;
  const double length = static_cast<double>(size) / parts;
  for (int k = 0; k < parts; ++k) {
    const double begin = k * length, end = (k + 1) * length;
    Part part{static_cast<int>(begin), {}};
    for (int i = part.first; i < size && i < end; ++i) {
      part.shares.push_back((std::min(end, i + 1.0) - std::max(begin, static_cast<double>(i))) / length);
    }
    result.push_back(std::move(part));
  }
  return result;
}

std::vector<float> heights_of(const moire::Image& image, const moire::Settings& settings) {
  const auto count = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  std::vector<float> heights(count);
  for (std::size_t k = 0; k < count; ++k) {
    const float value = image.values[k * static_cast<std::size_t>(image.channels)];
    if (!std::isfinite(value)) {
      const std::size_t width = static_cast<std::size_t>(image.width);
      throw moire::Error(settings.text("height") + ": height at column " + std::to_string(k % width) + ", row " +
                         std::to_string(k / width) + " is not a finite number; every pixel needs one");
    }
    heights[k] = value;
  }
  return heights;
}

std::vector<moire::Color> colors_of(const moire::Image& image) {
  std::vector<moire::Color> colors;
  colors.reserve(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) colors.push_back(moire::color_at(image, x, y));
  }
  return colors;
}

Terrain read_terrain(const moire::Settings& settings) {
  const moire::Image height = moire::read_image(settings.text("height"));
  const moire::Image color = moire::read_image(settings.text("color"));
  const moire::Image& grid = settings.text("grid") == "color" ? color : height;
  Terrain terrain;
  terrain.width = grid.width;
  terrain.height = grid.height;
  terrain.heights = resampled(heights_of(height, settings), height.width, height.height, grid.width, grid.height);
  terrain.colors = resampled(colors_of(color), color.width, color.height, grid.width, grid.height);
  return terrain;
}

// offset + scale (low + (high - low) u^exponent), u the height's place between the lowest and the highest.
// Error: the result is no finite float.
void scale_heights(std::vector<float>& heights, int width, double scale, double exponent, double offset) {
  const auto [low_at, high_at] = std::minmax_element(heights.begin(), heights.end());
  const double low = *low_at, range = *high_at - low;
  for (std::size_t k = 0; k < heights.size(); ++k) {
    const double height = heights[k];
    const double bent = range > 0 && exponent != 1 ? low + range * std::pow((height - low) / range, exponent) : height;
    const double scaled = offset + scale * bent;
    if (!(std::abs(scaled) <= std::numeric_limits<float>::max())) {
      const auto columns = static_cast<std::size_t>(width);
      throw moire::Error("heightfield: the height of column " + std::to_string(k % columns) + ", row " +
                         std::to_string(k / columns) + " is beyond 3.4e38 once scaled; give a smaller height_scale");
    }
    heights[k] = static_cast<float>(scaled);
  }
}

}  // namespace

template <class T>
std::vector<T> resampled(const std::vector<T>& values, int width, int height, int columns, int rows) {
  if (width == columns && height == rows) return values;
  const std::vector<Part> across = parts_of(width, columns), down = parts_of(height, rows);
  std::vector<T> result;
  result.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  for (const Part& row : down) {
    for (const Part& column : across) {
      T sum{};
      for (std::size_t j = 0; j < row.shares.size(); ++j) {
        const auto line = (static_cast<std::size_t>(row.first) + j) * static_cast<std::size_t>(width);
        for (std::size_t i = 0; i < column.shares.size(); ++i) {
          sum = sum + static_cast<float>(row.shares[j] * column.shares[i]) *
                          values[line + static_cast<std::size_t>(column.first) + i];
        }
      }
      result.push_back(sum);
    }
  }
  return result;
}

template std::vector<float> resampled(const std::vector<float>&, int, int, int, int);
template std::vector<moire::Color> resampled(const std::vector<moire::Color>&, int, int, int, int);

Terrain load_terrain(const moire::Settings& settings) {
  Terrain terrain = settings.text("height").empty()
                        ? fractal(static_cast<int>(settings.integer("size")),
                                  static_cast<std::uint64_t>(settings.integer("seed")), settings.real("relief"))
                        : read_terrain(settings);
  scale_heights(terrain.heights, terrain.width, settings.real("height_scale"), settings.real("height_exponent"),
                settings.real("height_offset"));
  return terrain;
}

}  // namespace heightfield
