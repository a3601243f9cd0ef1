// PNG files as they go into a page: their bytes as text, and their size.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <moire/geometry.h>

namespace moire::report {

struct PngFile {
  ImageSize size;
  std::string base64;
};

// Error: the file cannot be read or is no PNG.
PngFile read_png_file(const std::filesystem::path& file);

// RFC 4648, with padding.
std::string base64(std::string_view bytes);

}  // namespace moire::report
