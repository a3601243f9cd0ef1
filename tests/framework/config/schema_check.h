// Checks JSON against those keywords of JSON Schema (draft 7) that the experiment schema uses.
#pragma once

#include <nlohmann/json.hpp>

namespace moire::test {

// Throws std::logic_error if `schema` has a keyword that it does not know. `root` holds the definitions.
bool is_valid(const nlohmann::json& value, const nlohmann::json& schema, const nlohmann::json& root);

}  // namespace moire::test
