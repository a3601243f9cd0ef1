// Images: reading and writing are the module's, which is opened with the first image.
#include <moire/error.h>
#include <moire/image.h>

#include "sdk/images_module.h"

namespace moire {

Image read_image(const std::filesystem::path& file) {
  Image image;
  std::string problem;
  images_module().read(file.c_str(), image, problem);
  if (!problem.empty()) throw Error(problem);
  return image;
}

Color color_at(const Image& image, int x, int y) {
  const auto light = [&](int channel) {
    const double value = image.value(x, y, channel) / image.white;
    return static_cast<float>(image.is_linear ? value : srgb_to_linear(value));
  };
  const float first = light(0);
  return image.channels < 3 ? Color{first, first, first} : Color{first, light(1), light(2)};
}

void write_image(const std::filesystem::path& file, int width, int height, const std::vector<Color>& pixels,
                 Depth depth) {
  std::string problem;
  images_module().write(file.c_str(), width, height, pixels.data(), depth, problem);
  if (!problem.empty()) throw Error(problem);
}

}  // namespace moire
