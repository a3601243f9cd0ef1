#include "metrics/registry.h"

#include <array>

namespace moire {

std::span<const MetricEntry> metric_entries() {
  static constexpr std::array entries{
      MetricEntry{&error_description, make_error},
      MetricEntry{&coverage_description, make_coverage},
      MetricEntry{&speed_description, nullptr},
  };
  return entries;
}

std::span<const MetricDescription* const> metric_descriptions() {
  static const auto descriptions = [] {
    std::vector<const MetricDescription*> result;
    for (const MetricEntry& entry : metric_entries()) result.push_back(entry.description);
    return result;
  }();
  return descriptions;
}

}  // namespace moire
