// Which contender to take at equal time and at equal error.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <moire/settings.h>

#include "run/results.h"

namespace moire {

struct Priced {
  std::string name;
  double ms, error;
};

// Of those within the time the one of least error; errors up to `floor` are equal (NaN: none is), of equals the
// fastest.
std::optional<Priced> best_within_time(const std::vector<Priced>& all, double ms, double floor);
// Of those within the error, which is at least `floor`, the fastest.
std::optional<Priced> fastest_within_error(const std::vector<Priced>& all, double error, double floor);

// Adds an Analysis and its rows to `results`, from the rows of error and speed. A budget that cannot be read becomes a
// Failure.
void analyse_budgets(const Settings& settings, Results& results);

}  // namespace moire
