// results.json and manifest.json: all of a run's results, written and read back without loss.
#pragma once

#include <filesystem>

#include <nlohmann/json.hpp>

#include "run/results.h"

namespace moire::report {

// Numbers that are not finite become null (NaN), "inf" and "-inf". The manifest is a file of its own and not in here.
nlohmann::ordered_json to_json(const Results& results);

// The inverse of to_json. Error: `where` and what is not as it should be.
Results results_from_json(const nlohmann::ordered_json& json, const std::string& where);

// Writes results.json and manifest.json into the folder. Error: one cannot be written.
void write_json(const std::filesystem::path& folder, const Results& results);

// Reads both. Error: a file is missing, is no JSON, or was not written by this version of the format.
Results read_json(const std::filesystem::path& folder);

}  // namespace moire::report
