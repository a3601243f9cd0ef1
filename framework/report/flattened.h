// Nested JSON as a list of names and texts.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace moire::report {

// {"view": {"pitch_deg": -5}, "data": ["a", "b"]} gives view.pitch_deg = -5 and data = a, b.
std::vector<std::pair<std::string, std::string>> flattened(const nlohmann::ordered_json& json);

}  // namespace moire::report
