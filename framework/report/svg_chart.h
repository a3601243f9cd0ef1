// Two costs against each other on logarithmic axes, as inline SVG: points, their Pareto front, what is too small to
// tell.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "report/markup.h"

namespace moire::report {

struct ChartPoint {
  std::string label;
  double x = 0, y = 0;
  // Ends of an interval, NaN where there is none.
  double x_low = std::numeric_limits<double>::quiet_NaN(), x_high = x_low, y_low = x_low, y_high = x_low;
};

struct Chart {
  std::string title, x_axis, y_axis;
  std::vector<ChartPoint> points;  // x > 0 and finite; y >= 0 and finite, 0 is drawn on the lower edge
  // Values of y below cannot be told apart: they are drawn on it, and marked. NaN: no such.
  double floor = std::numeric_limits<double>::quiet_NaN();
  std::string floor_label;
};

// For each point, whether no other is at least as low in both and lower in one. Values of y below `floor` count as
// equal.
std::vector<bool> pareto_front(const std::vector<ChartPoint>& points,
                               double floor = std::numeric_limits<double>::quiet_NaN());

// Colours and type come from the page's style sheet by class. Empty if there are no points.
Markup scatter_chart(const Chart& chart);

}  // namespace moire::report
