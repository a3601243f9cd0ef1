// A logarithmic axis: which values it spans, where they lie and which of them are written beside it.
#pragma once

#include <span>
#include <vector>

namespace moire::report {

struct LogAxis {
  double low = 1, high = 10;  // values at the ends
  double from = 0, to = 1;    // coordinates of the ends

  // Values beyond an end, 0 too, lie on it. Requires: value is not NaN.
  double place(double value) const;

  // From 3 to about 10 round numbers within the ends: 1-2-5 steps, finer over less than a decade, whole decades over
  // more than three.
  std::vector<double> ticks() const;
};

// An axis with some air around the positive ones of the values; at least two thirds of a decade.
LogAxis axis_around(std::span<const double> values, double from, double to);

}  // namespace moire::report
