// results.csv: one line a number, as RFC 4180 has it, for spreadsheets and scripts.
#include "report/csv.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "files/whole_file.h"
#include "report/numbers.h"

namespace moire::report {
namespace {

std::string field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::string bound(double value) { return std::isnan(value) ? std::string() : exact_text(value); }

}  // namespace

std::string csv_text(const Results& results) {
  std::string text = "scene,sampler,metric,value,low,high,unit\r\n";
  for (const Row& row : results.rows) {
    text += fmt::format("{},{},{},{},{},{},{}\r\n", field(row.scene), field(row.sampler), field(row.metric),
                        exact_text(row.value), bound(row.low), bound(row.high), field(row.unit));
  }
  return text;
}

std::string curves_csv_text(const Results& results) {
  std::string text = "scene,sampler,curve,x,y\r\n";
  for (const CurveResult& curve : results.curves) {
    for (const auto& [x, y] : curve.points) {
      text += fmt::format("{},{},{},{},{}\r\n", field(curve.scene), field(curve.sampler), field(curve.kind),
                          exact_text(x), exact_text(y));
    }
  }
  return text;
}

void write_csv(const std::filesystem::path& folder, const Results& results) {
  write_whole_file(folder / "results.csv", csv_text(results));
  if (!results.curves.empty()) write_whole_file(folder / "curves.csv", curves_csv_text(results));
}

}  // namespace moire::report
