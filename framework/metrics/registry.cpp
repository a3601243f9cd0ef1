#include "metrics/registry.h"

#include <algorithm>
#include <array>

namespace moire {

std::span<const RegisteredMetric> registered_metrics() {
  static constexpr std::array entries{
      RegisteredMetric{.description = &error_description, .make = make_error},
      RegisteredMetric{.description = &coverage_description, .make = make_coverage},
      RegisteredMetric{.description = &spectrum_description, .make = make_spectrum},
      RegisteredMetric{.description = &points_description, .make = make_points},
      RegisteredMetric{.description = &strokes_description, .make = make_strokes},
      RegisteredMetric{.description = &convergence_description, .make = make_convergence, .is_analysis = true},
      RegisteredMetric{.description = &flicker_description, .make_temporal = make_flicker},
      RegisteredMetric{.description = &energy_description, .make_temporal = make_energy},
      RegisteredMetric{.description = &speed_description},
      RegisteredMetric{.description = &cost_description, .is_analysis = true},
      RegisteredMetric{.description = &budget_description, .is_analysis = true},
  };
  return entries;
}

std::span<const PassDescription* const> metric_descriptions() {
  static const auto descriptions = [] {
    std::vector<const PassDescription*> result;
    for (const RegisteredMetric& entry : registered_metrics()) result.push_back(entry.description);
    return result;
  }();
  return descriptions;
}

const RegisteredMetric& registered_metric(std::string_view name) {
  const auto entries = registered_metrics();
  return *std::find_if(entries.begin(), entries.end(), [&](const auto& e) { return e.description->name == name; });
}

}  // namespace moire
