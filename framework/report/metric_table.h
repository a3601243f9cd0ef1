// The numbers of one scene as a table of contenders by metrics, as every report shows it.
#pragma once

#include <string>
#include <vector>

#include "run/results.h"

namespace moire::report {

struct Cell {
  std::string value, low, high;     // as text; empty where there is none
  bool is_best = false;             // of the contenders in its column; several may share it
  bool is_below_reference = false;  // not above the reference's own error: as good as can be told, so never best alone
};

struct Column {
  Explanation metric;
  std::string pass, quantity;  // "error", "rmse" of "error.rmse"
};

struct Line {
  std::string sampler;
  bool is_contender = true;  // false: shown for comparison (the reference, an empty sampler), never best
  std::string failure;       // why there are no numbers, or empty
  std::vector<Cell> cells;   // one a column
};

struct MetricTable {
  std::vector<Column> columns;
  std::vector<Line> lines;  // contenders in their order, then others that have rows
};

// The metrics that the results explain or have rows of, in that order, without those that no row of this scene has.
MetricTable metric_table(const Results& results, const SceneResult& scene);

// Of a table's columns, those for which `keep(column)` holds.
template <class Keep>
MetricTable with_columns(const MetricTable& table, Keep keep) {
  MetricTable part;
  for (const Line& line : table.lines) part.lines.push_back({line.sampler, line.is_contender, line.failure, {}});
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (!keep(table.columns[c])) continue;
    part.columns.push_back(table.columns[c]);
    for (std::size_t l = 0; l < table.lines.size(); ++l) part.lines[l].cells.push_back(table.lines[l].cells[c]);
  }
  return part;
}

// The row of one number, or null.
const Row* find_row(const Results& results, const std::string& scene, const std::string& sampler,
                    const std::string& metric);

// As the metric is explained, else as its first row has it.
std::string unit_of(const Results& results, const std::string& metric);

// Metrics that reports treat by name: the error beside each picture, and the axes of speed against error.
inline const std::string main_error = "error.rmse";
inline const std::string main_speed = "speed.ms_per_frame";

// Whether it is in the unit of the reference's own error, whose rmse is known: a mean is no greater than that, so what
// is not above it cannot be told, and a maximum is not below its rmse.
inline bool is_size_of_error(const std::string& metric) {
  return metric == main_error || metric == "error.mae" || metric == "error.max";
}

}  // namespace moire::report
