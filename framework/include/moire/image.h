// Images in memory and in files. Reading and writing go through OpenImageIO, which is opened on first use: no plugin
// includes or links it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include <moire/color.h>

namespace moire {

// Values as the file stores them: an 8-bit file gives 0 .. 255, a 16-bit file 0 .. 65535, a float file its numbers.
struct Image {
  int width = 0, height = 0, channels = 0;
  double white = 1;           // the value that stands for full scale: 255, 65535, or 1 for float files
  bool is_linear = false;     // float files hold linear light, integer files sRGB code values
  std::vector<float> values;  // height x width x channels, row 0 the top

  float value(int x, int y, int channel) const {
    return values[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
                      static_cast<std::size_t>(channels) +
                  static_cast<std::size_t>(channel)];
  }
};

// Any format that OpenImageIO knows. Error: missing, unreadable or truncated file; more than 2^28 values.
Image read_image(const std::filesystem::path& file);

// One pixel in linear light; grey images give equal channels, alpha is ignored.
Color color_at(const Image& image, int x, int y);

// Linear light, row 0 the top. `file` ends in .exr (half: 11 bits, or float) or .png (8-bit sRGB, where a pixel that is
// not a number is magenta). Written whole or not at all. Error: the file cannot be written.
// Requires: pixels.size() == width * height, both above 0.
enum class Depth { half, full };
void write_image(const std::filesystem::path& file, int width, int height, const std::vector<Color>& pixels,
                 Depth depth = Depth::full);

}  // namespace moire
