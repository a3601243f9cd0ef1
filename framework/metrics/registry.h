// All metric passes. A new one is a file here and a line in registry.cpp.
#pragma once

#include <memory>
#include <span>

#include "metrics/metric.h"
#include "metrics/temporal_metric.h"

namespace moire {

struct RegisteredMetric {
  const PassDescription* description;
  // One of these; neither: the runner measures all contenders of a scene together (speed).
  std::unique_ptr<Metric> (*make)(const Settings&) = nullptr;
  std::unique_ptr<TemporalMetric> (*make_temporal)(const Settings&, ImageSize) = nullptr;

  bool is_analysis = false;  // works on rows, after the last scene: on those of others unless it makes its own

  bool is_timing() const { return !make && !make_temporal && !is_analysis; }
};

std::span<const RegisteredMetric> registered_metrics();
std::span<const PassDescription* const> metric_descriptions();
// Requires: a name of one of them.
const RegisteredMetric& registered_metric(std::string_view name);

extern const PassDescription error_description, coverage_description, spectrum_description, points_description,
    strokes_description, convergence_description, flicker_description, energy_description, speed_description,
    cost_description, budget_description;
std::unique_ptr<Metric> make_error(const Settings& settings);
std::unique_ptr<Metric> make_coverage(const Settings& settings);
std::unique_ptr<Metric> make_spectrum(const Settings& settings);
std::unique_ptr<Metric> make_points(const Settings& settings);
std::unique_ptr<Metric> make_strokes(const Settings& settings);
std::unique_ptr<Metric> make_convergence(const Settings& settings);
std::unique_ptr<TemporalMetric> make_flicker(const Settings& settings, ImageSize image);
std::unique_ptr<TemporalMetric> make_energy(const Settings& settings, ImageSize image);

}  // namespace moire
