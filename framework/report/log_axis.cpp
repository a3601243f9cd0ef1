// A logarithmic axis: which values it spans, where they lie and which of them are written beside it.
#include "report/log_axis.h"

#include <algorithm>
#include <cmath>

namespace moire::report {
namespace {

constexpr double smallest_span = 2.0 / 3;  // decades
constexpr double air = 0.08;               // of the span, at each end

std::vector<double> steps_for(double decades) {
  if (decades > 3) return {1};
  if (decades >= 1) return {1, 2, 5};
  return {1, 1.5, 2, 3, 4, 5, 7};
}

}  // namespace

double LogAxis::place(double value) const {
  const double inside = std::clamp(value, low, high);
  return from + (to - from) * std::log(inside / low) / std::log(high / low);
}

std::vector<double> LogAxis::ticks() const {
  const double decades = std::log10(high / low);
  const int stride = std::max(1, static_cast<int>(decades / 10));
  std::vector<double> ticks;
  for (int exponent = static_cast<int>(std::floor(std::log10(low))); std::pow(10.0, exponent) <= high;
       exponent += stride) {
    for (double step : steps_for(decades)) {
      const double tick = step * std::pow(10.0, exponent);
      if (low <= tick && tick <= high) ticks.push_back(tick);
    }
  }
  return ticks;
}

LogAxis axis_around(std::span<const double> values, double from, double to) {
  double low = HUGE_VAL, high = 0;
  for (double value : values) {
    if (!(value > 0) || std::isinf(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (high == 0) return {.low = 1, .high = 10, .from = from, .to = to};
  const double missing = std::max(0.0, smallest_span - std::log10(high / low)) / 2;
  const double margin = missing + air * std::max(smallest_span, std::log10(high / low));
  return {low / std::pow(10.0, margin), high * std::pow(10.0, margin), from, to};
}

}  // namespace moire::report
