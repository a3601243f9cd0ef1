// What all charts share: the sheet, its two logarithmic axes with their grid and titles, and pieces of SVG.
#pragma once

#include <string>

#include <moire/geometry.h>

#include "report/log_axis.h"
#include "report/markup.h"

namespace moire::report {

inline constexpr double chart_width = 960, chart_height = 520;
inline constexpr double chart_label_height = 16;

// A safe guess at the width of 13 px text in any sans-serif font.
double text_width(const std::string& text);

Markup svg_line(const char* kind, Point a, Point b);
Markup svg_text(const char* kind, Point at, const std::string& content);

// Grid, ticks and titles of axes that span `plot`.
Markup chart_axes(const Rectangle& plot, const LogAxis& x, const LogAxis& y, const std::string& x_title,
                  const std::string& y_title);

Markup chart_sheet(const std::string& title, const Markup& content);

}  // namespace moire::report
