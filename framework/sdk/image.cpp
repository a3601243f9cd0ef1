// Images: opens the module that knows OpenImageIO when the first image is read or written. OpenImageIO brings some 260
// libraries, half a second of every start, so that nothing else may link it.
#include <dlfcn.h>

#include <fmt/format.h>

#include <moire/error.h>
#include <moire/image.h>

#include "images/images.h"

namespace moire {

namespace {

struct Module {
  ReadImage* read;
  WriteImage* write;
};

// moire/moire_images.so beside this library, in the build tree as in an installation.
std::filesystem::path module_file() {
  Dl_info library;
  dladdr(reinterpret_cast<void*>(&module_file), &library);
  return std::filesystem::path(library.dli_fname).parent_path() / "moire" / "moire_images.so";
}

void* symbol(void* library, const char* name, const std::filesystem::path& file) {
  if (void* const found = dlsym(library, name)) return found;
  throw Error(fmt::format("{}: has no {}; build it together with this libmoire", file.string(), name));
}

Module open_module() {
  const std::filesystem::path file = module_file();
  void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) {
    throw Error(
        fmt::format("{}: cannot be opened ({}); reading and writing images needs this part of moire and the "
                    "OpenImageIO library (Debian: libopenimageio-dev)",
                    file.string(), dlerror()));
  }
  return {reinterpret_cast<ReadImage*>(symbol(library, read_image_symbol, file)),
          reinterpret_cast<WriteImage*>(symbol(library, write_image_symbol, file))};
}

// Opened once, by whichever thread comes first, and never closed.
const Module& module() {
  static const Module opened = open_module();
  return opened;
}

}  // namespace

Image read_image(const std::filesystem::path& file) {
  Image image;
  std::string problem;
  module().read(file.c_str(), image, problem);
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
  module().write(file.c_str(), width, height, pixels.data(), depth, problem);
  if (!problem.empty()) throw Error(problem);
}

}  // namespace moire
