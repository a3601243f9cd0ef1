// Timing of a scene's contenders: interleaved in one process, since only numbers of one sitting can be compared.
#pragma once

#include <functional>
#include <vector>

#include "run/contender.h"
#include "run/results.h"

namespace moire {

// Contenders of the host's own that every timing shows beside the others.
inline constexpr const char* floor_name = "nothing";

struct Timed {
  const Contender* contender;
  const Frame* frame;
  bool once = false;  // too slow to repeat: a single round, no warm-up
};

// Rows of the speed metric for each contender of `scene`. `settings` of speed_description; `progress` is called with
// the share of the rounds that are done.
std::vector<Row> measure_speed(const std::string& scene, const std::vector<Timed>& contenders, const Settings& settings,
                               std::uint64_t seed, const Workers& workers, const std::function<void(double)>& progress);

// Value at `share` of the way through the sorted values, interpolated; the median at 0.5. Requires: not empty.
double quantile(std::vector<double> values, double share);

}  // namespace moire
