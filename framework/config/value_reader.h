// Reads one JSON value as what a parameter declares.
#pragma once

#include <optional>
#include <string>

#include <moire/settings.h>
#include <nlohmann/json.hpp>

#include "config/data_files.h"
#include "json/json_tree.h"

namespace moire {

// The value of one parameter.
struct Cell {
  Value value;
  nlohmann::ordered_json written;  // what to write into an experiment to get this value from anywhere
  bool is_of_grid = false;         // one of a list of values
};

struct Reading {
  const DataFiles& files;
  Problems& problems;
};

// Nothing after adding a problem. `owner` is whose parameter it is, for messages.
std::optional<Cell> read_value(const JsonNode& node, const std::string& path, const Parameter& parameter,
                               std::string_view owner, const Reading& reading);

// The default, which is never checked: it is the plugin author's.
Cell default_cell(const Parameter& parameter);

}  // namespace moire
