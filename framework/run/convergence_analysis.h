// The slopes of error over samples, fitted to the rows of the convergence pass.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <moire/settings.h>

#include "run/results.h"

namespace moire {

// An error and its 95 % interval, at a number of samples.
struct ErrorAt {
  double samples, error, low, high;
};

struct PowerLaw {
  double slope, low, high;  // 95 % confidence
  double constant;          // of error = constant * samples^slope
};

// The line through log error over log samples. Each weighs as its interval says; the slope's interval comes from
// theirs, or from the scatter about the line where that is wider (three or more). Nothing: fewer than two different
// numbers of samples with errors above 0.
std::optional<PowerLaw> fit_power_law(const std::vector<ErrorAt>& errors);

// The number of samples at which a family has this error: on straight lines through the logarithms of its errors, by
// rising samples, and beyond the first and the last along the fitted law. NaN: none can be told, as where errors do not
// fall. Requires: error > 0.
double samples_at(double error, const std::vector<ErrorAt>& family);

// c of error = c N^slope with this slope, weighed in the same way. Requires: at least one error above 0.
double constant_for(const std::vector<ErrorAt>& errors, double slope);

// "jittered[n=4,amount=1]" without the settings named in `over` ("n points"): "jittered[amount=1]".
std::string family_of(std::string_view contender, std::string_view over);

// Adds slopes and constants of each family on each scene, a chart of each scene and an Analysis to `results`. What
// `theory` says that cannot be read, or of a family that is not there, becomes a Failure.
void analyse_convergence(const Settings& settings, Results& results);

}  // namespace moire
