// The options of a lookup or a filter.
#pragma once

#include <span>

#include <moire/settings.h>

namespace moire {

// The table's defaults, and what `settings` has of it.
inline Settings with_defaults(std::span<const Parameter> table, const Settings& settings) {
  Settings all(table);
  for (const Parameter& parameter : table) {
    const auto given = settings.values().find(parameter.name);
    if (given != settings.values().end()) all.set(parameter.name, given->second);
  }
  return all;
}

}  // namespace moire
