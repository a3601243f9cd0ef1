// Names for content: 128 bits of xxHash, as hexadecimal digits.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace moire {

std::string hash_of(std::string_view content);
// Error: the file cannot be read.
std::string hash_of_file(const std::filesystem::path& file);

}  // namespace moire
