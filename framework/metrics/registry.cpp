#include "metrics/registry.h"

#include <algorithm>
#include <array>

namespace moire {

std::span<const RegisteredMetric> registered_metrics() {
  static constexpr std::array entries{
      RegisteredMetric{&error_description, make_error},
      RegisteredMetric{&coverage_description, make_coverage},
      RegisteredMetric{&speed_description, nullptr},
  };
  return entries;
}

std::span<const MetricDescription* const> metric_descriptions() {
  static const auto descriptions = [] {
    std::vector<const MetricDescription*> result;
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
