// results.csv: one line a number, as RFC 4180 has it, for spreadsheets and scripts.
#pragma once

#include <filesystem>
#include <string>

#include "run/results.h"

namespace moire::report {

// The columns scene,sampler,metric,value,low,high,unit. A value that could not be computed is "nan"; low and high are
// empty where there is no interval.
std::string csv_text(const Results& results);

// The columns scene,sampler,curve,x,y.
std::string curves_csv_text(const Results& results);

// Writes results.csv, and curves.csv if there are any, into the folder. Error: it cannot be written.
void write_csv(const std::filesystem::path& folder, const Results& results);

}  // namespace moire::report
