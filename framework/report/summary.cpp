// The main numbers of a run as plain text, for the end of `moire run`.
#include "report/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "report/metric_table.h"
#include "report/numbers.h"

namespace moire::report {
namespace {

// The columns marked as main ones, and the first of each pass that marks none.
MetricTable main_part(const MetricTable& table) {
  std::set<std::string> passes_with_main, passes_seen;
  for (const Column& column : table.columns) {
    if (column.metric.is_main) passes_with_main.insert(column.pass);
  }
  return with_columns(table, [&](const Column& column) {
    const bool is_first = passes_seen.insert(column.pass).second;
    return column.metric.is_main || (is_first && !passes_with_main.count(column.pass));
  });
}

// Characters as a terminal shows them: UTF-8 continuation bytes take no room.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string padding(const std::string& text, std::size_t width) {
  return std::string(width - std::min(width, width_of(text)), ' ');
}

// Marks stand behind the numbers, in a place of their own, so that digits stay aligned.
std::string cell_text(const Cell& cell) {
  if (cell.value.empty()) return "- ";
  return cell.value + (cell.is_below_reference ? "~" : cell.is_best ? "*" : " ");
}

using TextRow = std::vector<std::string>;

std::vector<TextRow> text_rows(const MetricTable& table) {
  std::vector<TextRow> rows(2);
  rows[0].push_back("");
  rows[1].push_back("");
  for (const Column& column : table.columns) {
    rows[0].push_back(column.metric.metric + " ");
    rows[1].push_back(column.metric.unit + " ");
  }
  for (const Line& line : table.lines) {
    TextRow row{line.is_contender ? line.sampler : "(" + line.sampler + ")"};
    for (const Cell& cell : line.cells)
      row.push_back(cell.value.empty() && !line.failure.empty() ? "failed " : cell_text(cell));
    rows.push_back(std::move(row));
  }
  return rows;
}

// The first column to the left, numbers to the right.
std::string aligned(const std::vector<TextRow>& rows) {
  std::vector<std::size_t> widths(rows[0].size());
  for (const TextRow& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], width_of(row[c]));
  }
  std::string text;
  for (const TextRow& row : rows) {
    std::string line = "  " + row[0] + padding(row[0], widths[0]);
    for (std::size_t c = 1; c < row.size(); ++c) line += "  " + padding(row[c], widths[c]) + row[c];
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}

std::string left_out(const SceneResult& scene) {
  std::string names;
  for (const auto& [sampler, missing] : scene.without) names += (names.empty() ? "" : ", ") + sampler;
  return names.empty() ? "" : "  left out, since they do not fit: " + names + "\n";
}

std::string heading(const SceneResult& scene, const std::string& unit) {
  if (scene.reference.empty()) return scene.name + "\n";
  const std::string own_error =
      std::isnan(scene.reference_error)
          ? std::string()
          : fmt::format(" (its own error: {} {})", readable_text(scene.reference_error), unit);
  return fmt::format("{}, against {}{}\n", scene.name, scene.reference, own_error);
}

bool any_cell(const std::vector<MetricTable>& tables, bool Cell::*mark) {
  for (const MetricTable& table : tables) {
    for (const Line& line : table.lines) {
      if (std::any_of(line.cells.begin(), line.cells.end(), [&](const Cell& cell) { return cell.*mark; })) return true;
    }
  }
  return false;
}

}  // namespace

std::string summary_text(const Results& results) {
  std::string text;
  std::vector<MetricTable> tables;
  for (const SceneResult& scene : results.scenes) {
    tables.push_back(main_part(metric_table(results, scene)));
    text += heading(scene, unit_of(results, main_error)) + aligned(text_rows(tables.back())) + left_out(scene) + '\n';
  }
  for (const Analysis& analysis : results.analyses) {
    text += analysis.title + '\n';
    for (const std::string& statement : analysis.statements) text += "  " + statement + '\n';
    text += '\n';
  }
  if (any_cell(tables, &Cell::is_best)) text += "* best of the contenders\n";
  if (any_cell(tables, &Cell::is_below_reference)) text += "~ below the reference's accuracy: as good as can be told\n";
  for (const Failure& failure : results.failures) {
    text += fmt::format("failed: {} on {}: {}\n", failure.sampler, failure.scene, failure.message);
  }
  if (results.interrupted) text += "interrupted: only what had finished is shown\n";
  return text;
}

}  // namespace moire::report
