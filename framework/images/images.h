// What the module moire_images exports: functions that the SDK finds by name when the first image is touched. No
// exception leaves them; `problem` is the message of one, or stays empty.
#pragma once

#include <string>

#include <moire/image.h>

namespace moire {

using ReadImage = void(const char* file, Image& image, std::string& problem) noexcept;
using WriteImage = void(const char* file, int width, int height, const Color* pixels, Depth depth,
                        std::string& problem) noexcept;

inline constexpr char read_image_symbol[] = "moire_read_image";
inline constexpr char write_image_symbol[] = "moire_write_image";

}  // namespace moire
