// The numbers of one scene as a table of contenders by metrics, as every report shows it.
#include "report/metric_table.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "report/numbers.h"

namespace moire::report {
namespace {

Column column_of(const Explanation& metric) {
  const auto dot = metric.metric.rfind('.');
  if (dot == std::string::npos) return {metric, metric.metric, metric.metric};
  return {metric, metric.metric.substr(0, dot), metric.metric.substr(dot + 1)};
}

// Also those that nothing explains, so that no number is left out.
std::vector<Column> columns_of(const Results& results, const std::string& scene) {
  std::set<std::string> present, listed;
  for (const Row& row : results.rows) {
    if (row.scene == scene) present.insert(row.metric);
  }
  std::vector<Column> columns;
  for (const Explanation& metric : results.metrics) {
    if (present.count(metric.metric) && listed.insert(metric.metric).second) columns.push_back(column_of(metric));
  }
  for (const Row& row : results.rows) {
    if (row.scene == scene && listed.insert(row.metric).second) {
      columns.push_back(column_of({.metric = row.metric, .unit = row.unit, .meaning = "", .is_judged = false}));
    }
  }
  return columns;
}

std::vector<Line> lines_of(const Results& results, const SceneResult& scene) {
  std::vector<Line> lines;
  std::set<std::string> listed;
  for (const ContenderResult& contender : results.contenders) {
    listed.insert(contender.name);
    if (!scene.without.contains(contender.name)) lines.push_back({contender.name, true, "", {}});
  }
  for (const Row& row : results.rows) {
    if (row.scene == scene.name && listed.insert(row.sampler).second) lines.push_back({row.sampler, false, "", {}});
  }
  for (const Failure& failure : results.failures) {
    const auto line = std::find_if(lines.begin(), lines.end(), [&](auto& l) { return l.sampler == failure.sampler; });
    if (failure.scene == scene.name && line != lines.end()) line->failure = failure.message;
  }
  return lines;
}

// The best of the contenders' values; NaN if there is nothing to choose: fewer than two values, or all the same.
double best_value(const std::vector<const Row*>& rows, const std::vector<Line>& lines, const Explanation& metric) {
  double lowest = HUGE_VAL, highest = -HUGE_VAL;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!lines[i].is_contender || !rows[i] || std::isnan(rows[i]->value)) continue;
    lowest = std::min(lowest, rows[i]->value);
    highest = std::max(highest, rows[i]->value);
  }
  if (!metric.is_judged || !(lowest < highest)) return std::nan("");
  return metric.lower_is_better ? lowest : highest;
}

bool is_below_reference(const Row& row, const SceneResult& scene) {
  return is_size_of_error(row.metric) && scene.reference_error > 0 && row.value <= scene.reference_error;
}

Cell cell_of(const Row& row, int decimals, double best, const SceneResult& scene) {
  const auto bound = [&](double value) { return std::isnan(value) ? std::string() : readable_text(value, decimals); };
  const bool is_below = is_below_reference(row, scene);
  return {readable_text(row.value, decimals), bound(row.low), bound(row.high), row.value == best && !is_below,
          is_below};
}

void fill_column(const Results& results, const SceneResult& scene, const Explanation& metric,
                 std::vector<Line>& lines) {
  std::vector<const Row*> rows;
  std::vector<double> values;
  for (const Line& line : lines) {
    rows.push_back(find_row(results, scene.name, line.sampler, metric.metric));
    // What cannot be told from other small errors needs no digits.
    if (rows.back() && line.is_contender && !is_below_reference(*rows.back(), scene))
      values.push_back(rows.back()->value);
  }
  const int decimals = decimals_for(values);
  const double best = best_value(rows, lines, metric);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    lines[i].cells.push_back(rows[i] ? cell_of(*rows[i], decimals, best, scene) : Cell());
  }
}

}  // namespace

MetricTable metric_table(const Results& results, const SceneResult& scene) {
  MetricTable table{columns_of(results, scene.name), lines_of(results, scene)};
  for (const Column& column : table.columns) fill_column(results, scene, column.metric, table.lines);
  return table;
}

const Row* find_row(const Results& results, const std::string& scene, const std::string& sampler,
                    const std::string& metric) {
  for (const Row& row : results.rows) {
    if (row.metric == metric && row.sampler == sampler && row.scene == scene) return &row;
  }
  return nullptr;
}

std::string unit_of(const Results& results, const std::string& metric) {
  for (const Explanation& explanation : results.metrics) {
    if (explanation.metric == metric) return explanation.unit;
  }
  for (const Row& row : results.rows) {
    if (row.metric == metric) return row.unit;
  }
  return "";
}

}  // namespace moire::report
