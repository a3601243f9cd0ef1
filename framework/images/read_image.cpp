// Reads any format that OpenImageIO knows into floats with the file's own values.
#include <cmath>
#include <filesystem>

#include <OpenImageIO/imageio.h>

#include "images/boundary.h"
#include "images/images.h"

namespace moire {

namespace {

constexpr std::uint64_t most_values = std::uint64_t{1} << 28;  // 1 GiB of floats

void require_file(const char* file) {
  if (std::filesystem::is_regular_file(file)) return;
  const bool exists = std::filesystem::exists(file);
  throw Error(fmt::format("{}: {}; an image file is needed", file, exists ? "is no file" : "does not exist"));
}

std::unique_ptr<OIIO::ImageInput> open(const char* file) {
  require_file(file);
  OIIO::ImageSpec wish;
  wish["oiio:UnassociatedAlpha"] = 1;  // colours as stored, not multiplied by alpha
  auto input = OIIO::ImageInput::open(file, &wish);
  if (!input) {
    throw Error(fmt::format("{}: cannot be read as an image ({}); any format that OpenImageIO knows will do", file,
                            one_line(OIIO::geterror())));
  }
  return input;
}

// The stored value that stands for full scale.
double white(const OIIO::TypeDesc& stored, const char* file) {
  switch (stored.basetype) {
    case OIIO::TypeDesc::UINT8:
      return 255;
    case OIIO::TypeDesc::INT8:
      return 127;
    case OIIO::TypeDesc::UINT16:
      return 65535;
    case OIIO::TypeDesc::INT16:
      return 32767;
    case OIIO::TypeDesc::HALF:
    case OIIO::TypeDesc::FLOAT:
    case OIIO::TypeDesc::DOUBLE:
      return 1;
    default:
      throw Error(fmt::format("{}: has values of type {}; 8-bit, 16-bit and floating-point images can be read", file,
                              stored.c_str()));
  }
}

std::size_t value_count(const OIIO::ImageSpec& spec, const char* file) {
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1 || spec.depth > 1) {
    throw Error(
        fmt::format("{}: is {} x {} x {} pixels with {} channels; a flat image with at least one pixel is needed", file,
                    spec.width, spec.height, spec.depth, spec.nchannels));
  }
  const auto pixels = static_cast<std::uint64_t>(spec.width) * static_cast<std::uint64_t>(spec.height);
  const auto channels = static_cast<std::uint64_t>(spec.nchannels);
  if (pixels > most_values / channels) {
    throw Error(fmt::format("{}: is too large ({} x {} pixels, channels: {}); at most {} values can be read", file,
                            spec.width, spec.height, spec.nchannels, most_values));
  }
  return pixels * channels;
}

void read_values(OIIO::ImageInput& input, const char* file, Image& image) {
  const bool all_read = input.read_image(0, 0, 0, image.channels, OIIO::TypeDesc::FLOAT, image.values.data());
  // JPEG and TIFF fill rows that are missing, report success, and leave a message.
  if (!all_read || input.has_error()) {
    throw Error(fmt::format("{}: is damaged or cut short ({}); get the file again", file, one_line(input.geterror())));
  }
  // OpenImageIO divides integers by their type's largest value; up to 16 bits a float is fine enough to undo it.
  if (!image.is_linear) {
    for (float& value : image.values) value = std::round(value * static_cast<float>(image.white));
  }
}

Image read(const char* file) {
  const auto input = open(file);
  const OIIO::ImageSpec& spec = input->spec();
  Image image;
  image.width = spec.width;
  image.height = spec.height;
  image.channels = spec.nchannels;
  image.white = white(spec.format, file);
  image.is_linear = spec.format.is_floating_point();
  image.values.resize(value_count(spec, file));
  read_values(*input, file, image);
  return image;
}

}  // namespace

extern "C" __attribute__((visibility("default"))) ReadImage moire_read_image;

void moire_read_image(const char* file, Image& image, std::string& problem) noexcept {
  keep_exceptions_inside(file, problem, [&] { image = read(file); });
}

}  // namespace moire
