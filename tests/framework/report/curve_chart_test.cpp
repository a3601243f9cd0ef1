#include "report/curve_chart.h"

#include <catch2/catch_test_macros.hpp>

namespace moire::report {

TEST_CASE("a curve chart has a line for each curve and names it") {
  const std::string svg = curve_chart("Error", "samples", "rmse",
                                      {{"a < b", {{1, 0.1}, {10, 0.01}}}, {"c", {{1, 0.2}, {10, 0.1}}}, {"none", {}}})
                              .text();
  CHECK(svg.find("a &lt; b") != std::string::npos);
  std::size_t lines = 0;
  for (auto at = svg.find("<path"); at != std::string::npos; at = svg.find("<path", at + 1)) ++lines;
  CHECK(lines == 2);
  CHECK(svg.find(">none<") == std::string::npos);
  CHECK(svg.find("nan") == std::string::npos);
}

TEST_CASE("without points there is no chart") { CHECK(curve_chart("t", "x", "y", {{"empty", {}}}).text().empty()); }

TEST_CASE("names of curves that end together stand below each other within the sheet") {
  std::vector<ChartCurve> curves;
  for (int k = 0; k < 12; ++k) curves.push_back({"curve " + std::to_string(k), {{1, 1}, {2, 0.5}}});
  const std::string svg = curve_chart("t", "x", "y", curves).text();
  std::vector<double> heights;
  for (auto at = svg.find("class=\"label"); at != std::string::npos; at = svg.find("class=\"label", at + 1)) {
    const auto y = svg.find(" y=\"", at) + 4;
    heights.push_back(std::stod(svg.substr(y)));
  }
  REQUIRE(heights.size() == curves.size());
  std::sort(heights.begin(), heights.end());
  CHECK(heights.front() > 40);
  CHECK(heights.back() < 470);
  for (std::size_t k = 1; k < heights.size(); ++k) CHECK(heights[k] - heights[k - 1] >= 15.9);
}

}  // namespace moire::report
