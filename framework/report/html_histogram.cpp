#include "report/html_histogram.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/error_map.h"
#include "report/html_table.h"
#include "report/numbers.h"

namespace moire::report {
namespace {

constexpr std::string_view prefix = "flicker.changed_by_";

// "6_up" as people say it.
std::string change_of(const std::string& metric) {
  std::string change = metric.substr(prefix.size());
  const auto up = change.find("_up");
  return up == std::string::npos ? change : change.substr(0, up) + " and more";
}

// From black for the largest change through the error maps' colours to light grey for none.
std::string style_of(std::size_t k, std::size_t count, double share) {
  const double t = 1 - static_cast<double>(k) / static_cast<double>(count);
  return fmt::format("width:{:.3f}%;background:{}", 100 * share, css_color(absolute_error_color(t, 1)));
}

Markup bar(const Results& results, const std::string& scene, const std::string& sampler,
           const std::vector<std::string>& metrics) {
  Markup parts;
  for (std::size_t k = 0; k < metrics.size(); ++k) {
    const Row* row = find_row(results, scene, sampler, metrics[k]);
    if (!row || !(row->value > 0)) continue;
    parts += tag("span",
                 {{"style", style_of(k, metrics.size(), row->value)},
                  {"title", fmt::format("{}: {}", change_of(metrics[k]), readable_text(row->value))}},
                 "");
  }
  return parts;
}

}  // namespace

Markup change_histogram(const Results& results, const MetricTable& table, const std::string& scene) {
  std::vector<std::string> metrics;
  for (const Column& column : table.columns) {
    if (column.metric.metric.starts_with(prefix)) metrics.push_back(column.metric.metric);
  }
  if (metrics.empty()) return {};
  Markup rows, legend;
  for (const Line& line : table.lines) {
    const Markup parts = bar(results, scene, line.sampler, metrics);
    if (parts.text().empty()) continue;
    rows += tag("tr", tag("th", {{"scope", "row"}}, line.sampler) +
                          tag("td", {{"class", "bar"}}, tag("div", {{"class", "shares"}}, parts)));
  }
  for (std::size_t k = 0; k < metrics.size(); ++k) {
    legend += tag("li", tag("span", {{"class", "key"}, {"style", style_of(k, metrics.size(), 0.01)}}, "") +
                            Markup(change_of(metrics[k])));
  }
  return tag("h3", "Changes from frame to frame") +
         tag("p", {{"class", "note"}}, "Shares of pixels that change by so many 8-bit codes between two frames.") +
         tag("ul", {{"class", "legend"}}, legend) + scrolling_table("Changes from frame to frame", {}, rows);
}

}  // namespace moire::report
