// The soundness of a shared object as a file.
#pragma once

#include <filesystem>
#include <string_view>

namespace moire {

// Error: not a shared object for x86-64, or shorter than its headers say. Opening one that is cut short kills the
// process when the linker touches what is missing. Names `file` in messages; `bytes` is all of it.
void require_whole_shared_object(const std::filesystem::path& file, std::string_view bytes);

}  // namespace moire
