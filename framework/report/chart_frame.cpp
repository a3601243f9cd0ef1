#include "report/chart_frame.h"

#include <fmt/format.h>

namespace moire::report {

double text_width(const std::string& text) { return 7.4 * static_cast<double>(text.size()) + 4; }

Markup svg_line(const char* kind, Point a, Point b) {
  return tag("line",
             {{"class", kind},
              {"x1", coordinate(a.x)},
              {"y1", coordinate(a.y)},
              {"x2", coordinate(b.x)},
              {"y2", coordinate(b.y)}},
             "");
}

Markup svg_text(const char* kind, Point at, const std::string& content) {
  return tag("text", {{"class", kind}, {"x", coordinate(at.x)}, {"y", coordinate(at.y)}}, content);
}

Markup chart_axes(const Rectangle& plot, const LogAxis& x, const LogAxis& y, const std::string& x_title,
                  const std::string& y_title) {
  Markup out;
  for (double tick : x.ticks()) {
    const double at = x.place(tick);
    out += svg_line("grid", {at, plot.y0}, {at, plot.y1}) +
           svg_text("tick x", {at, plot.y1 + 20}, fmt::format("{:g}", tick));
  }
  for (double tick : y.ticks()) {
    const double at = y.place(tick);
    out += svg_line("grid", {plot.x0, at}, {plot.x1, at}) +
           svg_text("tick y", {plot.x0 - 10, at + 4}, fmt::format("{:g}", tick));
  }
  out += svg_line("axis", {plot.x0, plot.y1}, {plot.x1, plot.y1});
  return out + svg_text("title y", {0, 18}, "\u2191 " + y_title) +
         svg_text("title x", {plot.x1, chart_height - 14}, x_title + " \u2192");
}

Markup chart_sheet(const std::string& title, const Markup& content) {
  const std::string box = fmt::format("0 0 {} {}", chart_width, chart_height);
  return tag("svg", {{"class", "chart"}, {"viewBox", box}, {"role", "img"}, {"aria-label", title}}, content);
}

}  // namespace moire::report
