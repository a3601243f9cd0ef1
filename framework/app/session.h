// What every command works with: the plugins, and what an experiment may speak of.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "config/experiment.h"
#include "loading/catalog.h"

namespace moire::app {

struct Session {
  Catalog catalog;
  Vocabulary vocabulary;  // points at the catalog

  // Opens the plugins beside the program, of MOIRE_PLUGIN_PATH and of `folders`. Error: some cannot be opened.
  explicit Session(const std::vector<std::filesystem::path>& folders);
  Session(const Session&) = delete;
};

}  // namespace moire::app
