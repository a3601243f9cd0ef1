#include "report/curve_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "report/chart_frame.h"
#include "report/numbers.h"

namespace moire::report {
namespace {

constexpr Rectangle sheet{64, 40, 936, 456};
constexpr std::size_t colors = 8;  // classes hue-0 .. hue-7 of the style sheet
constexpr double gap = 14;         // between the plot and the names

std::string hue(std::size_t index) {
  return fmt::format("hue-{}{}", index % colors, index / colors % 2 ? " dashed" : "");
}

Markup polyline(const ChartCurve& curve, std::size_t index, const LogAxis& x, const LogAxis& y) {
  std::string path;
  Markup dots;
  for (const auto& [px, py] : curve.points) {
    const Point at{x.place(px), y.place(py)};
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", at.x, at.y);
    dots += tag("circle", {{"cx", coordinate(at.x)}, {"cy", coordinate(at.y)}, {"r", "2.5"}},
                tag("title", fmt::format("{}: {} at {}", curve.label, readable_text(py), readable_text(px))));
  }
  return tag("g", {{"class", "curve " + hue(index)}}, tag("path", {{"d", path}}, "") + dots);
}

// Heights of the names beside the plot: as near to the ends of their curves as they fit below each other.
std::vector<double> name_heights(const std::vector<double>& ends) {
  std::vector<std::size_t> order(ends.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return ends[a] < ends[b]; });
  std::vector<double> heights(ends.size());
  double free = sheet.y0;
  for (std::size_t k : order) {
    heights[k] = std::max(ends[k], free);
    free = heights[k] + chart_label_height;
  }
  // What hangs over the lower edge pushes up those above it.
  double limit = sheet.y1;
  for (auto k = order.rbegin(); k != order.rend(); ++k) {
    heights[*k] = std::min(heights[*k], limit);
    limit = heights[*k] - chart_label_height;
  }
  return heights;
}

}  // namespace

Markup curve_chart(const std::string& title, const std::string& x_axis, const std::string& y_axis,
                   const std::vector<ChartCurve>& curves) {
  std::vector<const ChartCurve*> shown;
  std::vector<double> xs, ys;
  double names = 0;
  for (const ChartCurve& curve : curves) {
    if (curve.points.empty()) continue;
    shown.push_back(&curve);
    names = std::max(names, text_width(curve.label));
    for (const auto& [x, y] : curve.points) {
      xs.push_back(x);
      ys.push_back(y);
    }
  }
  if (shown.empty()) return {};

  const Rectangle plot{sheet.x0, sheet.y0, std::max(sheet.x1 - gap - names, (sheet.x0 + sheet.x1) / 2), sheet.y1};
  const LogAxis x = axis_around(xs, plot.x0, plot.x1), y = axis_around(ys, plot.y1, plot.y0);
  std::vector<double> ends;
  for (const ChartCurve* curve : shown) ends.push_back(y.place(curve->points.back()[1]));
  const auto heights = name_heights(ends);
  Markup lines, labels;
  for (std::size_t k = 0; k < shown.size(); ++k) {
    lines += polyline(*shown[k], k, x, y);
    labels +=
        svg_line("leader", {x.place(shown[k]->points.back()[0]), ends[k]}, {plot.x1 + gap - 3, heights[k]}) +
        tag("text", {{"class", "label " + hue(k)}, {"x", coordinate(plot.x1 + gap)}, {"y", coordinate(heights[k] + 4)}},
            shown[k]->label);
  }
  return chart_sheet(title, chart_axes(plot, x, y, x_axis, y_axis) + labels + lines);
}

}  // namespace moire::report
