// Files that are there whole or not at all.
#pragma once

#include <filesystem>
#include <string_view>

namespace moire {

// Replaces the file in one step, through a temporary name in the same folder. Safe from many threads and processes.
// Error: the file cannot be written; what was there stays as it was.
void write_whole_file(const std::filesystem::path& file, std::string_view content);

// Error: the file cannot be read.
std::string read_whole_file(const std::filesystem::path& file);

}  // namespace moire
