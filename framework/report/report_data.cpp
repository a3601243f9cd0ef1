// What a page shows, worked out from results and pictures and free of any markup.
#include "report/report_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include <moire/error.h>

#include "report/json.h"
#include "report/numbers.h"
#include "run/detail_window.h"

namespace moire::report {
namespace {

namespace fs = std::filesystem;

// The pictures of a page, each file read once.
class Album {
 public:
  Album(const fs::path& folder, std::vector<PngFile>& pictures) : folder_(folder), pictures_(pictures) {}

  void put(Panel& panel, const fs::path& file) {
    try {
      check_is_below_folder(file);
      const auto [known, is_new] = indices_.try_emplace(file, pictures_.size());
      if (is_new) pictures_.push_back(read_png_file(folder_ / file));
      panel.picture = known->second;
    } catch (const Error& problem) {
      indices_.erase(file);
      panel.problem = problem.what();
    }
  }

 private:
  // Results may come from somebody else; a page never shows files from outside their folder.
  void check_is_below_folder(const fs::path& file) const {
    const fs::path plain = file.lexically_normal();
    if (plain.is_relative() && *plain.begin() != "..") return;
    throw Error(fmt::format("{}: is not shown (it lies outside {}); pictures lie below the result folder",
                            file.string(), folder_.string()));
  }

  const fs::path& folder_;
  std::vector<PngFile>& pictures_;
  std::map<fs::path, std::size_t> indices_;
};

std::string with_unit(const std::string& number, const std::string& unit) {
  return unit.empty() ? number : number + ' ' + unit;
}

std::string failure_of(const Results& results, const std::string& scene, const std::string& sampler) {
  for (const Failure& failure : results.failures) {
    if (failure.scene == scene && failure.sampler == sampler) return failure.message;
  }
  return "";
}

const ImageResult* find_image(const Results& results, const std::string& scene, const std::string& sampler,
                              const std::string& kind) {
  for (const ImageResult& image : results.images) {
    if (image.scene == scene && image.sampler == sampler && image.kind == kind) return &image;
  }
  return nullptr;
}

// The text of one number in a table, so that it reads the same wherever it stands.
const Cell* find_cell(const MetricTable& table, const std::string& sampler, const std::string& metric) {
  for (const Line& line : table.lines) {
    for (std::size_t c = 0; c < line.cells.size(); ++c) {
      if (line.sampler == sampler && table.columns[c].metric.metric == metric && !line.cells[c].value.empty()) {
        return &line.cells[c];
      }
    }
  }
  return nullptr;
}

Panel panel_of(const ReportData& data, const SceneView& view, const std::string& sampler) {
  Panel panel;
  panel.name = sampler;
  if (const Cell* cell = find_cell(view.table, sampler, main_error)) {
    panel.error = with_unit(cell->value, data.error_unit);
    panel.is_below_reference = cell->is_below_reference;
  }
  return panel;
}

PictureRow image_row(const ReportData& data, const SceneView& view, Album& album) {
  PictureRow row{"image", 0, {}};
  if (!view.scene.reference_image.empty()) {
    row.panels.emplace_back().name = "reference";
    album.put(row.panels.back(), view.scene.reference_image);
  }
  for (const ContenderResult& contender : data.results.contenders) {
    if (view.scene.without.contains(contender.name)) continue;
    row.panels.push_back(panel_of(data, view, contender.name));
    if (const ImageResult* image = find_image(data.results, view.scene.name, contender.name, "image")) {
      album.put(row.panels.back(), image->file);
    } else {
      const std::string failure = failure_of(data.results, view.scene.name, contender.name);
      row.panels.back().problem = failure.empty() ? "not rendered in this run" : failure;
    }
  }
  return row;
}

// Of each kind but "image", in order of appearance. Pictures of another scale make a row of their own, under its own
// scale.
std::vector<PictureRow> other_rows(const ReportData& data, const SceneView& view, Album& album) {
  std::vector<PictureRow> rows;
  for (const ImageResult& image : data.results.images) {
    if (image.scene != view.scene.name || image.kind == "image") continue;
    auto row = std::find_if(rows.begin(), rows.end(),
                            [&](const PictureRow& r) { return r.kind == image.kind && r.scale == image.scale; });
    if (row == rows.end()) row = rows.insert(row, {image.kind, image.scale, {}});
    Panel& panel = row->panels.emplace_back(panel_of(data, view, image.sampler));
    panel.caption = image.caption;
    // How a method samples is not to be read by the error of its image.
    if (!panel.caption.empty()) panel.error.clear();
    album.put(panel, image.file);
  }
  return rows;
}

// The window the run chose if it lies in the image, else the middle.
std::array<int, 4> detail_window(const Results& results, const SceneResult& scene) {
  const auto [x, y, width, height] = scene.detail_window;
  const bool is_inside =
      x >= 0 && y >= 0 && width > 0 && height > 0 && width <= results.width - x && height <= results.height - y;
  return is_inside ? scene.detail_window : middle_window({results.width, results.height});
}

std::string axis_title(const Results& results, const std::string& metric) {
  const std::string unit = unit_of(results, metric);
  return unit.empty() ? metric : fmt::format("{} ({})", metric, unit);
}

void fill_chart(const Results& results, SceneView& view) {
  view.chart = {fmt::format("Speed against error on {}", view.scene.name),
                axis_title(results, main_speed),
                axis_title(results, main_error),
                {},
                view.scene.reference_error,
                "below the reference\u2019s accuracy"};
  for (const ContenderResult& contender : results.contenders) {
    if (view.scene.without.contains(contender.name)) continue;
    const Row* speed = find_row(results, view.scene.name, contender.name, main_speed);
    const Row* error = find_row(results, view.scene.name, contender.name, main_error);
    if (speed && error && std::isfinite(speed->value) && speed->value > 0 && std::isfinite(error->value)) {
      view.chart.points.push_back(
          {contender.name, speed->value, error->value, speed->low, speed->high, error->low, error->high});
    } else {
      view.not_in_chart.push_back(contender.name);
    }
  }
}

// Who has the mark in a metric's column, and its number.
Finding best_of(const MetricTable& table, const std::string& title, const std::string& metric, const std::string& unit,
                bool Cell::*mark) {
  Finding finding{title, "", ""};
  for (const Line& line : table.lines) {
    const Cell* cell = find_cell(table, line.sampler, metric);
    if (!cell || !(cell->*mark) || !line.is_contender) continue;
    finding.name += (finding.name.empty() ? "" : ", ") + line.sampler;
    finding.detail += (finding.detail.empty() ? "" : ", ") + with_unit(cell->value, unit);
  }
  return finding;
}

Finding front_of(const Chart& chart) {
  Finding finding{"Pareto front", "", ""};
  if (chart.points.size() < 2) return finding;
  const std::vector<bool> is_front = pareto_front(chart.points, chart.floor);
  for (std::size_t i = 0; i < is_front.size(); ++i) {
    if (is_front[i]) finding.name += (finding.name.empty() ? "" : ", ") + chart.points[i].label;
  }
  finding.detail = fmt::format("{} of {} are beaten by none in both speed and error",
                               std::count(is_front.begin(), is_front.end(), true), is_front.size());
  return finding;
}

void fill_findings(const Results& results, SceneView& view) {
  const std::string error_unit = unit_of(results, main_error), speed_unit = unit_of(results, main_speed);
  for (Finding finding :
       {best_of(view.table, "Smallest error", main_error, error_unit, &Cell::is_best),
        best_of(view.table, "Below the reference\u2019s accuracy", main_error, error_unit, &Cell::is_below_reference),
        best_of(view.table, "Fastest", main_speed, speed_unit, &Cell::is_best), front_of(view.chart)}) {
    if (!finding.name.empty()) view.findings.push_back(std::move(finding));
  }
}

}  // namespace

ReportData read_report_data(const fs::path& folder) {
  ReportData data;
  data.results = read_json(folder);
  data.error_unit = unit_of(data.results, main_error);
  Album album(folder, data.pictures);
  for (const SceneResult& scene : data.results.scenes) {
    SceneView view;
    view.scene = scene;
    view.table = metric_table(data.results, scene);
    view.images = image_row(data, view, album);
    view.detail_window = detail_window(data.results, scene);
    view.other_rows = other_rows(data, view, album);
    fill_chart(data.results, view);
    fill_findings(data.results, view);
    data.scenes.push_back(std::move(view));
  }
  return data;
}

}  // namespace moire::report
