// Reads the settings of a plugin or metric from its object; lists of values are a grid.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "config/value_reader.h"

namespace moire {

// A cell for each row of a table, in its order.
using Cells = std::vector<Cell>;

// Whose settings are read.
struct SettingsOwner {
  std::string_view name;
  std::span<const Parameter> table;
  std::span<const std::string_view> other_keys;  // what its object may hold besides, such as "type"
  bool takes_grids = false;
};

// All combinations of the values given, the last parameter changing fastest; defaults fill up. Empty after adding
// problems: all that this object has.
std::vector<Cells> read_settings(const JsonNode& object, const std::string& path, const SettingsOwner& owner,
                                 const Reading& reading);

Settings settings_of(std::span<const Parameter> table, const Cells& cells);

// The object that gives these settings: "view.pitch_deg" as a member of "view".
void write_settings(std::span<const Parameter> table, const Cells& cells, nlohmann::ordered_json& object);

}  // namespace moire
