// Lines over logarithmic axes, as inline SVG: one for each contender, named at its end.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "report/markup.h"

namespace moire::report {

struct ChartCurve {
  std::string label;
  std::vector<std::array<double, 2>> points;  // above 0 and finite, by rising x
};

// Empty if no curve has a point. Colours and type come from the page's style sheet by class.
Markup curve_chart(const std::string& title, const std::string& x_axis, const std::string& y_axis,
                   const std::vector<ChartCurve>& curves);

}  // namespace moire::report
