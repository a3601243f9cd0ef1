// All metric passes. A new one is a file here and a line in registry.cpp.
#pragma once

#include <memory>
#include <span>

#include "metrics/metric.h"

namespace moire {

struct RegisteredMetric {
  const MetricDescription* description;
  // Null: the pass does not judge one contender after another; the runner measures all of a scene together (speed).
  std::unique_ptr<Metric> (*make)(const Settings&);
};

std::span<const RegisteredMetric> registered_metrics();
std::span<const MetricDescription* const> metric_descriptions();
// Requires: a name of one of them.
const RegisteredMetric& registered_metric(std::string_view name);

extern const MetricDescription error_description, coverage_description, speed_description;
std::unique_ptr<Metric> make_error(const Settings& settings);
std::unique_ptr<Metric> make_coverage(const Settings& settings);

}  // namespace moire
