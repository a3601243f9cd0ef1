// Files that are there whole or not at all.
#include "files/whole_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>

#include <moire/error.h>

namespace moire {
namespace {

namespace fs = std::filesystem;

// In the same folder, since a rename across file systems is a copy.
fs::path temporary_name(const fs::path& file) {
  static std::atomic<unsigned> count = 0;
  return file.parent_path() / fmt::format(".{}.{}-{}.part", file.filename().string(), getpid(), count++);
}

[[noreturn]] void refuse_to_write(const fs::path& file, const std::string& reason) {
  throw Error(fmt::format("{}: cannot be written ({}); the folder must exist, be writable and have room", file.string(),
                          reason));
}

}  // namespace

void write_whole_file(const fs::path& file, std::string_view content) {
  const fs::path part = temporary_name(file);
  std::error_code ignored;
  errno = 0;
  std::ofstream stream(part, std::ios::binary);
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  if (!stream) {
    const std::string reason = std::strerror(errno);
    fs::remove(part, ignored);
    refuse_to_write(file, reason);
  }
  std::error_code problem;
  fs::rename(part, file, problem);
  if (problem) {
    fs::remove(part, ignored);
    refuse_to_write(file, problem.message());
  }
}

std::string read_whole_file(const fs::path& file) {
  errno = fs::is_directory(file) ? EISDIR : 0;
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (stream && errno == 0) {
    std::string content(static_cast<std::size_t>(stream.tellg()), '\0');
    stream.seekg(0);
    stream.read(content.data(), static_cast<std::streamsize>(content.size()));
    if (stream) return content;
  }
  throw Error(fmt::format("{}: cannot be read ({}); a readable file is needed", file.string(), std::strerror(errno)));
}

}  // namespace moire
