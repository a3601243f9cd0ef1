#include "report/metric_table.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "framework/report/sample_results.h"

namespace moire::report {
namespace {

MetricTable table_of(const Results& results) { return metric_table(results, results.scenes[0]); }

// The contenders marked best in a metric's column.
std::vector<std::string> best(const Results& results, const std::string& metric) {
  const MetricTable table = table_of(results);
  std::vector<std::string> names;
  for (const Line& line : table.lines) {
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
      if (table.columns[c].metric.metric == metric && line.cells[c].is_best) names.push_back(line.sampler);
    }
  }
  return names;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("the best is the lowest or the highest, as the metric says; not-a-number is never best") {
  const Results results = test::sample_results();
  CHECK(best(results, "error.max") == Names{"super[n=2]"});
  CHECK(best(results, "coverage.ratio") == Names{"super[n=2]"});
  CHECK(best(results, "coverage.visible") == Names{});
}

TEST_CASE("what is no contender is listed and never best") {
  const Results results = test::sample_results();
  CHECK(table_of(results).lines.back().sampler == "empty");
  CHECK(best(results, "speed.ms_per_frame") == Names{"point"});
}

TEST_CASE("equals share the mark, and nothing is best where all are equal") {
  Results results = test::sample_results();
  results.rows[12].value = 2;  // the area's time: now that of point
  CHECK(best(results, "speed.ms_per_frame") == Names{"point", "area"});
  results.rows[11].value = 2;
  CHECK(best(results, "speed.ms_per_frame") == Names{});
}

TEST_CASE("an error below the reference's own is marked as such instead of as best") {
  const MetricTable table = table_of(test::sample_results());
  REQUIRE(table.lines[2].sampler == "area");
  CHECK(table.lines[2].cells[0].is_below_reference);
  CHECK_FALSE(table.lines[2].cells[0].is_best);
}

TEST_CASE("means and maxima of an error are marked too, also right at the reference's own") {
  Results results = test::sample_results();
  results.scenes[0].reference_error = 96;
  const MetricTable table = table_of(results);
  REQUIRE(table.columns[1].metric.metric == "error.max");
  CHECK(table.lines[1].cells[1].is_below_reference);        // 96
  CHECK_FALSE(table.lines[0].cells[1].is_below_reference);  // infinite
  CHECK(best(results, "error.max") == Names{});
  CHECK(best(results, "coverage.ratio") == Names{"super[n=2]"});
}

TEST_CASE("an error too small to tell does not lengthen the others") {
  Results results = test::sample_results();
  results.rows[2].value = 3e-7;
  const MetricTable table = table_of(results);
  CHECK(table.lines[0].cells[0].value == "12.50");
  CHECK(table.lines[2].cells[0].value == "3.0e-07");
}

TEST_CASE("a reference without an error of its own hides none") {
  Results results = test::sample_results();
  results.rows[2].value = 0;
  for (const double own : {0.0, std::nan("")}) {
    results.scenes[0].reference_error = own;
    CHECK(best(results, "error.rmse") == Names{"area"});
  }
}

TEST_CASE("a failed contender keeps its line and its reason") {
  const Line line = table_of(test::sample_results()).lines[3];
  CHECK(line.failure == "it threw: <oops> & more");
  CHECK(line.cells[0].value.empty());
}

TEST_CASE("a metric that nothing explains is shown but not judged") {
  Results results = test::sample_results();
  results.rows.push_back({"hill, steep", "point", "flicker.mean", 1, std::nan(""), std::nan(""), "levels"});
  const Column column = table_of(results).columns.back();
  CHECK(column.pass == "flicker");
  CHECK(column.quantity == "mean");
  CHECK_FALSE(column.metric.is_judged);
}

}  // namespace moire::report
