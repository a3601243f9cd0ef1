// Writes EXR in linear light and PNG in 8-bit sRGB, whole or not at all.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "files/whole_file.h"
#include "images/boundary.h"
#include "images/images.h"

namespace moire {

namespace {

namespace fs = std::filesystem;

Error cannot_encode(const fs::path& file, const std::string& reason) {
  return Error(fmt::format("{}: cannot be encoded ({}); OpenImageIO must know the format of its extension",
                           file.string(), one_line(reason)));
}

// `values` are of the type `type`, three to a pixel. OpenImageIO chooses the format by the extension. It encodes into
// memory, since it does not notice when a disk is full.
void save(const fs::path& file, const OIIO::ImageSpec& spec, const OIIO::TypeDesc& type, const void* values) {
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const auto output = OIIO::ImageOutput::create(file.string(), &memory);
  if (!output) throw cannot_encode(file, OIIO::geterror());
  if (!output->open(file.string(), spec) || !output->write_image(type, values) || !output->close()) {
    throw cannot_encode(file, output->geterror());
  }
  write_whole_file(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

void save_exr(const fs::path& file, int width, int height, const Color* pixels, Depth depth) {
  static_assert(sizeof(Color) == 3 * sizeof(float));
  OIIO::ImageSpec spec(width, height, 3, depth == Depth::half ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT);
  spec["oiio:ColorSpace"] = "Linear";
  spec["DateTime"] = "";  // else OpenImageIO writes the time of day, and no two runs give the same file
  save(file, spec, OIIO::TypeDesc::FLOAT, pixels);
}

std::uint8_t code_value(float light) { return static_cast<std::uint8_t>(srgb_code(light)); }

std::array<std::uint8_t, 3> code_values(Color color) {
  if (std::isnan(color.r) || std::isnan(color.g) || std::isnan(color.b)) return {255, 0, 255};
  return {code_value(color.r), code_value(color.g), code_value(color.b)};
}

void save_png(const fs::path& file, int width, int height, const Color* pixels) {
  std::vector<std::array<std::uint8_t, 3>> codes(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  std::transform(pixels, pixels + codes.size(), codes.begin(), code_values);
  OIIO::ImageSpec spec(width, height, 3, OIIO::TypeDesc::UINT8);
  spec["oiio:ColorSpace"] = "sRGB";
  save(file, spec, OIIO::TypeDesc::UINT8, codes.data());
}

void write(const fs::path& file, int width, int height, const Color* pixels, Depth depth) {
  if (file.extension() == ".exr") {
    save_exr(file, width, height, pixels, depth);
  } else if (file.extension() == ".png") {
    save_png(file, width, height, pixels);
  } else {
    throw Error(fmt::format("{}: is no kind of image that is written here (\"{}\"); use .exr or .png", file.string(),
                            file.extension().string()));
  }
}

}  // namespace

extern "C" __attribute__((visibility("default"))) WriteImage moire_write_image;

void moire_write_image(const char* file, int width, int height, const Color* pixels, Depth depth,
                       std::string& problem) noexcept {
  keep_exceptions_inside(file, problem, [&] { write(file, width, height, pixels, depth); });
}

}  // namespace moire
