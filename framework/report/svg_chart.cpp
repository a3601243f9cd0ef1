// Two costs against each other on logarithmic axes, as inline SVG.
#include "report/svg_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "report/chart_frame.h"
#include "report/label_placement.h"
#include "report/numbers.h"

namespace moire::report {
namespace {

constexpr Rectangle plot{64, 40, 936, 456};

class Drawing {
 public:
  explicit Drawing(const Chart& chart) : chart_(chart), is_front_(pareto_front(chart.points, chart.floor)) {
    std::vector<double> xs, ys;
    for (const ChartPoint& p : chart.points) {
      xs.insert(xs.end(), {p.x, p.x_low, p.x_high});
      for (double y : {p.y, p.y_low, p.y_high}) ys.push_back(told(y));
    }
    x_ = axis_around(xs, plot.x0, plot.x1);
    y_ = axis_around(ys, plot.y1, plot.y0);
    // A floor just below the points is worth seeing; one far below would squeeze them.
    if (chart.floor < y_.low && chart.floor > y_.low / 10) y_.low = chart.floor / 1.25;
  }

  Markup svg() const {
    return chart_sheet(chart_.title,
                       chart_axes(plot, x_, y_, chart_.x_axis, chart_.y_axis) + floor() + front() + marks() + labels());
  }

 private:
  // Where a value of y stands: on the floor if it cannot be told from others below.
  double told(double y) const { return y < chart_.floor ? chart_.floor : y; }
  bool is_on_floor(const ChartPoint& p) const { return chart_.floor > 0 && p.y <= chart_.floor; }
  Point place(const ChartPoint& p) const { return {x_.place(p.x), y_.place(told(p.y))}; }

  Markup floor() const {
    if (!(chart_.floor > y_.low)) return {};
    const double y = y_.place(chart_.floor);
    return tag("rect",
               {{"class", "floor"},
                {"x", coordinate(plot.x0)},
                {"y", coordinate(y)},
                {"width", coordinate(plot.x1 - plot.x0)},
                {"height", coordinate(plot.y1 - y)}},
               "") +
           svg_text("floor", {plot.x1 - 8, plot.y1 - 8}, chart_.floor_label);
  }

  // The corners of the front from left to right: at each point's cost one gets its error, until the next.
  std::vector<Point> front_corners() const {
    std::vector<Point> corners;
    for (std::size_t i = 0; i < chart_.points.size(); ++i) {
      if (is_front_[i]) corners.push_back(place(chart_.points[i]));
    }
    std::sort(corners.begin(), corners.end(), [](Point a, Point b) { return a.x < b.x || (a.x == b.x && a.y > b.y); });
    std::vector<Point> steps;
    for (const Point& p : corners) {
      steps.push_back({p.x, steps.empty() ? plot.y0 : steps.back().y});
      steps.push_back(p);
    }
    if (!steps.empty()) steps.push_back({plot.x1, steps.back().y});
    return steps;
  }

  Markup front() const {
    std::string path;
    for (const Point& p : front_corners()) path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", p.x, p.y);
    return tag("path", {{"class", "front"}, {"d", path}}, "");
  }

  Markup marks() const {
    Markup out;
    for (std::size_t i = 0; i < chart_.points.size(); ++i) {
      const ChartPoint& p = chart_.points[i];
      const Point at = place(p);
      const std::string remark = is_on_floor(p) ? fmt::format(" ({})", chart_.floor_label) : "";
      Markup mark = tag("title", fmt::format("{}: {} {}, {} {}{}", p.label, chart_.x_axis, readable_text(p.x),
                                             chart_.y_axis, readable_text(p.y), remark));
      if (p.x_low < p.x_high) mark += svg_line("interval", {x_.place(p.x_low), at.y}, {x_.place(p.x_high), at.y});
      if (told(p.y_low) < told(p.y_high))
        mark += svg_line("interval", {at.x, y_.place(told(p.y_low))}, {at.x, y_.place(told(p.y_high))});
      mark += tag("circle", {{"cx", coordinate(at.x)}, {"cy", coordinate(at.y)}, {"r", "5"}}, "");
      out += tag(
          "g", {{"class", fmt::format("point{}{}", is_front_[i] ? "" : " dominated", is_on_floor(p) ? " below" : "")}},
          mark);
    }
    return out;
  }

  Markup labels() const {
    std::vector<std::size_t> order(chart_.points.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_partition(order.begin(), order.end(), [&](std::size_t i) { return is_front_[i]; });
    std::vector<LabelWish> wishes;
    std::vector<std::string> texts;
    for (std::size_t i : order) {
      const ChartPoint& p = chart_.points[i];
      texts.push_back(p.y == 0 && !is_on_floor(p) ? p.label + " (0)" : p.label);
      wishes.push_back({place(p), text_width(texts.back())});
    }
    const auto placed = place_labels(wishes, chart_label_height, plot, obstacles());
    Markup leaders, out;
    for (std::size_t i = 0; i < placed.size(); ++i) {
      if (placed[i].needs_leader) leaders += leader(placed[i].box, wishes[i].point);
      out += label(placed[i].box, wishes[i].point, texts[i], is_front_[order[i]]);
    }
    return leaders + out;
  }

  static Markup leader(const Rectangle& box, Point point) {
    return svg_line("leader", point,
                    {std::clamp(point.x, box.x0, box.x1), std::clamp(point.y, box.y0 + 3, box.y1 - 3)});
  }

  // The text ends at the side that faces its point, so that a wrong guess at its width shows at the far side only.
  static Markup label(const Rectangle& box, Point point, const std::string& content, bool is_front) {
    const std::string anchor = point.x < box.x0 ? "start" : point.x > box.x1 ? "end" : "middle";
    const double x = anchor == "start" ? box.x0 : anchor == "end" ? box.x1 : (box.x0 + box.x1) / 2;
    return tag("text",
               {{"class", is_front ? "label" : "label dominated"},
                {"text-anchor", anchor},
                {"x", coordinate(x)},
                {"y", coordinate(box.y1 - 4)}},
               content);
  }

  // What labels keep clear of.
  std::vector<Rectangle> obstacles() const {
    const auto corners = front_corners();
    std::vector<Rectangle> lines;
    if (chart_.floor > y_.low) {
      lines.push_back(
          {plot.x1 - 8 - text_width(chart_.floor_label), plot.y1 - 8 - chart_label_height, plot.x1, plot.y1});
    }
    for (std::size_t i = 1; i < corners.size(); ++i) {
      const Point &a = corners[i - 1], &b = corners[i];
      lines.push_back({std::min(a.x, b.x) - 1, std::min(a.y, b.y) - 1, std::max(a.x, b.x) + 1, std::max(a.y, b.y) + 1});
    }
    return lines;
  }

  const Chart& chart_;
  std::vector<bool> is_front_;
  LogAxis x_, y_;
};

}  // namespace

std::vector<bool> pareto_front(const std::vector<ChartPoint>& points, double floor) {
  const auto height_of = [&](const ChartPoint& p) { return p.y < floor ? floor : p.y; };
  const auto dominates = [&](const ChartPoint& a, const ChartPoint& b) {
    return a.x <= b.x && height_of(a) <= height_of(b) && (a.x < b.x || height_of(a) < height_of(b));
  };
  std::vector<bool> is_front;
  for (const ChartPoint& point : points) {
    is_front.push_back(
        std::none_of(points.begin(), points.end(), [&](auto& other) { return dominates(other, point); }));
  }
  return is_front;
}

Markup scatter_chart(const Chart& chart) { return chart.points.empty() ? Markup() : Drawing(chart).svg(); }

}  // namespace moire::report
