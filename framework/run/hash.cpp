#include "run/hash.h"

#include <fstream>
#include <vector>

#include <fmt/format.h>
#include <xxhash.h>

#include <moire/error.h>

namespace moire {

namespace {
std::string digits(XXH128_hash_t hash) { return fmt::format("{:016x}{:016x}", hash.high64, hash.low64); }
}  // namespace

std::string hash_of(std::string_view content) { return digits(XXH3_128bits(content.data(), content.size())); }

std::string hash_of_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Error(fmt::format("{}: cannot be read", file.string()));
  XXH3_state_t* state = XXH3_createState();
  XXH3_128bits_reset(state);
  std::vector<char> buffer(std::size_t{1} << 20);
  while (stream.read(buffer.data(), static_cast<std::streamsize>(buffer.size())) || stream.gcount() > 0) {
    XXH3_128bits_update(state, buffer.data(), static_cast<std::size_t>(stream.gcount()));
  }
  const std::string hash = digits(XXH3_128bits_digest(state));
  XXH3_freeState(state);
  return hash;
}

}  // namespace moire
