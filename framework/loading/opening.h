// Opening a plugin whose record has been checked.
#pragma once

#include <filesystem>

#include <moire/plugin.h>

#include "loading/catalog.h"

namespace moire {

// Runs the static constructors of the file. The library is never closed: what it makes, and the exceptions it throws,
// may outlive whoever asked. Error: it cannot be opened, or does not export what it ought to.
Plugin open_plugin(const std::filesystem::path& file, const Record& record);

}  // namespace moire
