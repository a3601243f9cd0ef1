// A plugin's record, read from the file without opening it as a library.
#pragma once

#include <filesystem>

#include <moire/plugin.h>

namespace moire {

// Error: the file is no whole shared object for x86-64, is no plugin, or was built for another interface. Opening it
// afterwards runs its code, but cannot fail for these reasons. Name and version are text; the name need not be the
// file's.
Record read_record(const std::filesystem::path& file);

}  // namespace moire
