// The numbers of a scene as HTML tables, one a metric pass, and what each metric means.
#include "report/html_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace moire::report {
namespace {

std::string anchor_of(const Explanation& metric) { return "metric-" + metric.metric; }

Markup direction(const Explanation& metric) {
  if (!metric.is_judged) return {};
  return tag("span",
             {{"class", "direction"}, {"title", metric.lower_is_better ? "lower is better" : "higher is better"}},
             metric.lower_is_better ? "\u2193" : "\u2191");
}

Markup head_cell(const Results& results, const Column& column) {
  const Explanation& metric = column.metric;
  const bool is_explained = std::any_of(results.metrics.begin(), results.metrics.end(),
                                        [&](const Explanation& e) { return e.metric == metric.metric; });
  const Markup name =
      is_explained
          ? tag("a", {{"href", fmt::format("#{}", anchor_of(metric))}, {"title", metric.meaning}}, column.quantity)
          : Markup(column.quantity);
  return tag("th", {{"scope", "col"}}, name + direction(metric) + tag("span", {{"class", "unit"}}, metric.unit));
}

Markup data_cell(const Cell& cell) {
  if (cell.value.empty()) return tag("td", {{"class", "none"}}, "\u2013");
  Markup content = cell.value;
  if (cell.is_best) content = tag("strong", content) + tag("span", {{"class", "spoken"}}, " (best)");
  if (cell.is_below_reference) {
    content = tag("span", {{"class", "below"}, {"title", "below the reference\u2019s accuracy"}}, content);
  }
  if (!cell.low.empty() || !cell.high.empty()) {
    content += tag("span", {{"class", "interval"}}, cell.low + " \u2013 " + cell.high);
  }
  return tag("td", {{"class", cell.is_best ? "best" : ""}}, content);
}

Markup body_row(const Line& line) {
  Markup cells = tag("th", {{"scope", "row"}}, line.sampler);
  const bool is_empty =
      std::all_of(line.cells.begin(), line.cells.end(), [](const Cell& c) { return c.value.empty(); });
  if (is_empty && !line.failure.empty()) {
    cells +=
        tag("td", {{"class", "failure"}, {"colspan", std::to_string(line.cells.size())}}, "failed: " + line.failure);
  } else {
    for (const Cell& cell : line.cells) cells += data_cell(cell);
  }
  return tag("tr", {{"class", line.is_contender ? "" : "aside"}}, cells);
}

Markup pass_table(const Results& results, const std::string& pass, const MetricTable& table) {
  Markup head = tag("th", {{"scope", "col"}}, "contender"), rows;
  for (const Column& column : table.columns) head += head_cell(results, column);
  for (const Line& line : table.lines) {
    const bool has_numbers =
        std::any_of(line.cells.begin(), line.cells.end(), [](const Cell& c) { return !c.value.empty(); });
    if (line.is_contender || has_numbers) rows += body_row(line);
  }
  return tag("h4", pass) + scrolling_table(pass, tag("tr", head), rows);
}

}  // namespace

Markup metric_tables(const Results& results, const MetricTable& table) {
  std::vector<std::string> passes;
  for (const Column& column : table.columns) {
    if (std::find(passes.begin(), passes.end(), column.pass) == passes.end()) passes.push_back(column.pass);
  }
  Markup tables;
  for (const std::string& pass : passes) {
    tables += pass_table(results, pass, with_columns(table, [&](const Column& column) { return column.pass == pass; }));
  }
  return tables;
}

Markup glossary(const Results& results) {
  Markup rows;
  for (const Explanation& metric : results.metrics) {
    const std::string better = !metric.is_judged ? "describes" : metric.lower_is_better ? "lower" : "higher";
    rows += tag("tr", {{"id", anchor_of(metric)}},
                tag("th", {{"scope", "row"}}, metric.metric) + tag("td", metric.unit) + tag("td", better) +
                    tag("td", {{"class", "prose"}}, metric.meaning));
  }
  const Markup head = tag("th", {{"scope", "col"}}, "metric") + tag("th", {{"scope", "col"}}, "unit") +
                      tag("th", {{"scope", "col"}}, "better") + tag("th", {{"scope", "col"}}, "meaning");
  return scrolling_table("Metrics", tag("tr", head), rows);
}

Markup scrolling_table(const std::string& label, const Markup& head, const Markup& rows) {
  const Markup table = tag("table", (head.text().empty() ? Markup() : tag("thead", head)) + tag("tbody", rows));
  return tag("div", {{"class", "wide"}, {"role", "region"}, {"aria-label", label}, {"tabindex", "0"}}, table);
}

}  // namespace moire::report
