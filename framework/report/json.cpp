// results.json and manifest.json: all of a run's results, written and read back without loss.
#include "report/json.h"

#include <fmt/format.h>

#include <cmath>
#include <concepts>

#include <moire/error.h>

#include "files/whole_file.h"
#include "report/numbers.h"

namespace moire::report {
namespace {

using Json = nlohmann::ordered_json;

// Rises when a reader of the old format would misread the new one.
constexpr int format_version = 2;

// T is U or const U: members() below serves writing and reading alike, so that the two cannot differ.
template <class T, class U>
concept Either = std::same_as<std::remove_const_t<T>, U>;

void members(auto& file, Either<Row> auto& row) {
  file.field("scene", row.scene);
  file.field("sampler", row.sampler);
  file.field("metric", row.metric);
  file.field("value", row.value);
  file.field("low", row.low);
  file.field("high", row.high);
  file.field("unit", row.unit);
}

void members(auto& file, Either<SceneResult> auto& scene) {
  file.field("name", scene.name);
  file.field("type", scene.type);
  file.field("version", scene.version);
  file.field("summary", scene.summary);
  file.field("settings", scene.settings);
  file.field("without", scene.without);
  file.field("reference", scene.reference);
  file.field("reference_error", scene.reference_error);
  file.field("reference_error_how", scene.reference_error_how);
  file.field("reference_origin", scene.reference_origin);
  file.field("fragments_reference", scene.fragments_reference);
  file.field("reference_image", scene.reference_image);
  file.field("detail_window", scene.detail_window);
}

void members(auto& file, Either<ContenderResult> auto& contender) {
  file.field("name", contender.name);
  file.field("type", contender.type);
  file.field("version", contender.version);
  file.field("lookup", contender.lookup);
  file.field("summary", contender.summary);
  file.field("source", contender.source);
  file.field("settings", contender.settings);
}

void members(auto& file, Either<Explanation> auto& metric) {
  file.field("metric", metric.metric);
  file.field("unit", metric.unit);
  file.field("meaning", metric.meaning);
  file.field("lower_is_better", metric.lower_is_better);
  file.field("is_judged", metric.is_judged);
  file.field("is_main", metric.is_main);
}

void members(auto& file, Either<ImageResult> auto& image) {
  file.field("scene", image.scene);
  file.field("sampler", image.sampler);
  file.field("kind", image.kind);
  file.field("file", image.file);
  file.field("scale", image.scale);
  file.field("caption", image.caption);
}

void members(auto& file, Either<Failure> auto& failure) {
  file.field("scene", failure.scene);
  file.field("sampler", failure.sampler);
  file.field("message", failure.message);
}

void members(auto& file, Either<CurveResult> auto& curve) {
  file.field("scene", curve.scene);
  file.field("sampler", curve.sampler);
  file.field("kind", curve.kind);
  file.field("title", curve.title);
  file.field("x_axis", curve.x_axis);
  file.field("y_axis", curve.y_axis);
  file.field("points", curve.points);
}

void members(auto& file, Either<Analysis> auto& analysis) {
  file.field("title", analysis.title);
  file.field("statements", analysis.statements);
}

void members(auto& file, Either<Results> auto& results) {
  file.field("experiment", results.experiment);
  file.field("question", results.question);
  file.field("width", results.width);
  file.field("height", results.height);
  file.field("interrupted", results.interrupted);
  file.list("scenes", results.scenes);
  file.list("contenders", results.contenders);
  file.list("metrics", results.metrics);
  file.list("failures", results.failures);
  file.list("rows", results.rows);
  file.list("images", results.images);
  file.list("analyses", results.analyses);
  file.list("curves", results.curves);
  file.field("jobs", results.jobs);
}

class Writer {
 public:
  Json json = Json::object();

  void field(const char* name, const auto& value) { json[name] = value; }
  void field(const char* name, const std::filesystem::path& value) { json[name] = value.generic_string(); }
  void field(const char* name, const double& value) {
    if (std::isfinite(value)) {
      json[name] = value;
    } else if (std::isnan(value)) {
      json[name] = nullptr;
    } else {
      json[name] = exact_text(value);
    }
  }
  void list(const char* name, const auto& values) {
    Json& array = json[name] = Json::array();
    for (const auto& value : values) {
      Writer element;
      members(element, value);
      array.push_back(std::move(element.json));
    }
  }
};

class Reader {
 public:
  explicit Reader(const Json& json) : json_(json) {}

  void field(const char* name, auto& value) const { json_.at(name).get_to(value); }
  void field(const char* name, Json& value) const { value = json_.at(name); }
  void field(const char* name, std::filesystem::path& value) const { value = json_.at(name).get<std::string>(); }
  void field(const char* name, double& value) const {
    const Json& number = json_.at(name);
    if (number.is_null()) {
      value = std::numeric_limits<double>::quiet_NaN();
    } else if (number == "inf" || number == "-inf") {
      value = number == "inf" ? HUGE_VAL : -HUGE_VAL;
    } else {
      number.get_to(value);
    }
  }
  template <class T>
  void list(const char* name, std::vector<T>& values) const {
    for (const Json& element : json_.at(name)) {
      const Reader reader(element);
      members(reader, values.emplace_back());
    }
  }

 private:
  const Json& json_;
};

// nlohmann's messages open with its own number: "[json.exception.out_of_range.403] key 'unit' not found".
std::string without_number(const std::string& message) {
  const auto end = message.find("] ");
  return end == std::string::npos ? message : message.substr(end + 2);
}

Json parse_file(const std::filesystem::path& file) {
  try {
    return Json::parse(read_whole_file(file));
  } catch (const Json::parse_error& problem) {
    throw Error(fmt::format("{}: is not JSON ({}); run the experiment again to write it anew", file.string(),
                            without_number(problem.what())));
  }
}

}  // namespace

Json to_json(const Results& results) {
  Writer file;
  file.field("format_version", format_version);
  members(file, results);
  return std::move(file.json);
}

Results results_from_json(const Json& json, const std::string& where) {
  try {
    if (const int found = json.at("format_version"); found != format_version) {
      throw Error(fmt::format("{}: has another format (version {}); this program reads version {}", where, found,
                              format_version));
    }
    Results results;
    const Reader reader(json);
    members(reader, results);
    return results;
  } catch (const Json::exception& problem) {
    throw Error(fmt::format("{}: is not a file of results ({}); run the experiment again to write it anew", where,
                            without_number(problem.what())));
  }
}

void write_json(const std::filesystem::path& folder, const Results& results) {
  write_whole_file(folder / "manifest.json", results.manifest.dump(2) + '\n');
  write_whole_file(folder / "results.json", to_json(results).dump(2) + '\n');
}

Results read_json(const std::filesystem::path& folder) {
  const auto file = folder / "results.json";
  Results results = results_from_json(parse_file(file), file.string());
  results.manifest = parse_file(folder / "manifest.json");
  return results;
}

}  // namespace moire::report
