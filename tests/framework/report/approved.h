// Approved copies: what a test makes is compared with a file as a whole. MOIRE_APPROVE=1 in the environment renews the
// files; read the diff before committing it.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include "files/whole_file.h"

namespace moire::test {

inline std::string approved(const std::string& name, const std::string& made) {
  const std::filesystem::path file = std::filesystem::path(MOIRE_APPROVED_REPORTS) / name;
  if (std::getenv("MOIRE_APPROVE")) write_whole_file(file, made);
  return read_whole_file(file);
}

}  // namespace moire::test
