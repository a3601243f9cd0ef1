// Numbers as text: for files, which must give back the same number, and for people.
#include "report/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace moire::report {

std::string exact_text(double value) {
  if (std::isnan(value)) return "nan";  // fmt keeps the sign of a NaN, which means nothing
  return fmt::format("{}", value);
}

int decimals_for(std::span<const double> column) {
  double smallest = HUGE_VAL;
  bool are_whole = true;
  for (double value : column) {
    if (!std::isfinite(value) || value == 0) continue;
    smallest = std::min(smallest, std::abs(value));
    are_whole = are_whole && value == std::floor(value);
  }
  if (are_whole) return 0;
  return std::clamp(2 - static_cast<int>(std::floor(std::log10(smallest))), 0, 4);
}

std::string readable_text(double value, int decimals) {
  if (!std::isfinite(value)) return exact_text(value);
  const double size = std::abs(value);
  if (size >= 1e9 || (size > 0 && size < 0.5 * std::pow(10.0, -decimals))) return fmt::format("{:.1e}", value);
  return fmt::format("{:.{}f}", value, decimals);
}

std::string readable_text(double value) { return readable_text(value, decimals_for({&value, 1})); }

}  // namespace moire::report
