// PNG files as they go into a page: their bytes as text, and their size.
#include "report/png_file.h"

#include <fmt/format.h>

#include <cstdint>

#include <moire/error.h>

#include "files/whole_file.h"

namespace moire::report {
namespace {

// A PNG opens with its signature and the chunk IHDR, whose first two numbers are width and height.
constexpr std::string_view signature("\x89PNG\r\n\x1a\n", 8);
constexpr std::size_t header_at = 12, width_at = 16, height_at = 20, header_end = 24;

int big_endian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (char byte : bytes.substr(0, 4)) value = value << 8 | static_cast<unsigned char>(byte);
  return static_cast<int>(value);
}

}  // namespace

PngFile read_png_file(const std::filesystem::path& file) {
  const std::string bytes = read_whole_file(file);
  if (bytes.size() < header_end || !bytes.starts_with(signature) || bytes.compare(header_at, 4, "IHDR") != 0) {
    throw Error(fmt::format("{}: is no PNG ({} bytes); run the experiment again to write it anew", file.string(),
                            bytes.size()));
  }
  const std::string_view view = bytes;
  return {{big_endian(view.substr(width_at)), big_endian(view.substr(height_at))}, base64(bytes)};
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::string_view group = bytes.substr(i, 3);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (k < group.size() ? static_cast<unsigned char>(group[k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += k <= group.size() ? digits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

}  // namespace moire::report
