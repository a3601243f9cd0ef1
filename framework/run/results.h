// All that a run found out, and the only thing a report is made from (with the images beside it).
#pragma once

#include <array>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace moire {

// The reference's name in rows and images that it has beside the contenders.
inline constexpr const char* reference_name = "reference";

// One number. low and high: a spread or an interval, NaN where there is none. A value that could not be computed is
// NaN.
struct Row {
  std::string scene, sampler, metric;
  double value = std::numeric_limits<double>::quiet_NaN();
  double low = std::numeric_limits<double>::quiet_NaN();
  double high = std::numeric_limits<double>::quiet_NaN();
  std::string unit;
};

struct SceneResult {
  std::string name, type, version;
  nlohmann::ordered_json settings;
  std::string reference;  // recipe: "area[method=line,lines=32,layout=radial], levels=none"
  double reference_error = std::numeric_limits<double>::quiet_NaN();  // rmse, in units of error.rmse; NaN: no reference
  std::string reference_error_how;                                    // how that number was got, one sentence
  std::string reference_origin;                                       // "computed now", "kept from before"
  std::string fragments_reference;        // what fragments are held against, where that is another sampler; else empty
  std::filesystem::path reference_image;  // below the result folder; empty if none
  std::array<int, 4> detail_window{};     // x, y, width, height: what reports magnify; all 0: the middle of the image
  std::string summary;                    // the plugin's sentence on what it is
  std::map<std::string, std::string> without;  // contenders that do not fit, and what they miss here
};

struct ContenderResult {
  std::string name, type, version, lookup;
  nlohmann::ordered_json settings;
  std::string summary, source;  // the plugin's: what it does, after which paper
};

// A picture of one contender on one scene.
struct ImageResult {
  std::string scene, sampler;
  std::string kind;            // "image", "error_absolute", "error_signed", or of a picture: "footprint_2"
  std::filesystem::path file;  // a PNG below the result folder; an EXR of the same name may lie beside it
  double scale = 0;            // of error maps: the value (in units of error.rmse) at the end of the colour scale
  std::string caption = "";    // of pictures: what is shown
};

// A contender that did not finish on a scene, and why.
struct Failure {
  std::string scene, sampler, message;
};

// What a pass over all scenes found out, in sentences; its rows have its title as their scene.
struct Analysis {
  std::string title;
  std::vector<std::string> statements;
};

// A line of a chart of one scene. Both axes are logarithmic.
struct CurveResult {
  std::string scene, sampler;
  std::string kind;  // "spectrum.error_power"
  std::string title, x_axis, y_axis;
  std::vector<std::array<double, 2>> points;
};

// What a metric means; the fields of a pass's Quantity.
struct Explanation {
  std::string metric, unit, meaning;
  bool lower_is_better = true;
  bool is_judged = true;  // false: describes (a count of elements, say), neither end is better
  bool is_main = false;   // among the few numbers that a summary shows
};

struct Results {
  std::string experiment, question;
  int width = 0, height = 0;
  std::vector<SceneResult> scenes;
  std::vector<ContenderResult> contenders;
  std::vector<Row> rows;
  std::vector<ImageResult> images;
  std::vector<Failure> failures;
  std::vector<Explanation> metrics;
  std::vector<Analysis> analyses;
  std::vector<CurveResult> curves;
  bool interrupted = false;
  std::map<std::string, std::string> jobs;  // "scene/sampler" to the job's key
  nlohmann::ordered_json manifest;          // versions, hashes, machine, date, command
};

}  // namespace moire
