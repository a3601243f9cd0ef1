// What a page shows, worked out from results and pictures and free of any markup.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "report/metric_table.h"
#include "report/png_file.h"
#include "report/svg_chart.h"

namespace moire::report {

// A contender's (or the reference's) place in a row of pictures.
struct Panel {
  static constexpr std::size_t no_picture = static_cast<std::size_t>(-1);

  std::string name;
  std::size_t picture = no_picture;  // index into ReportData::pictures
  std::string problem;               // why there is no picture
  std::string error;                 // "12.4 levels", or empty
  std::string caption;               // of pictures of how a method samples: what is shown
  bool is_below_reference = false;
};

// Pictures of one kind. Error maps have a scale, which all of them share.
struct PictureRow {
  std::string kind;  // of ImageResult
  double scale = 0;  // 0: these are no error maps
  std::vector<Panel> panels;
};

struct Finding {
  std::string title, name, detail;
};

struct SceneView {
  SceneResult scene;
  std::vector<Finding> findings;
  PictureRow images;  // the reference, if there is one, then the contenders
  std::array<int, 4> detail_window{};
  std::vector<PictureRow> other_rows;
  MetricTable table;
  Chart chart;                            // of speed against error; empty without both
  std::vector<std::string> not_in_chart;  // contenders that lack one of the two
};

struct ReportData {
  Results results;
  std::string error_unit;
  std::vector<PngFile> pictures;  // each file once
  std::vector<SceneView> scenes;
};

// Reads a result folder. A picture that is missing or broken becomes a panel's problem. Error: results that cannot be
// read.
ReportData read_report_data(const std::filesystem::path& folder);

}  // namespace moire::report
