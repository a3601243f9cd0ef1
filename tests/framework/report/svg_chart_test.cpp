#include "report/svg_chart.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "framework/report/approved.h"
#include "report/label_placement.h"
#include "report/log_axis.h"

namespace moire::report {

using Flags = std::vector<bool>;
using Ticks = std::vector<double>;

TEST_CASE("ticks are round numbers: 1-2-5 over decades, finer within one, whole decades over many") {
  CHECK(LogAxis{.low = 3, .high = 120}.ticks() == Ticks{5, 10, 20, 50, 100});
  CHECK(LogAxis{.low = 1.2, .high = 6}.ticks() == Ticks{1.5, 2, 3, 4, 5});
  CHECK(LogAxis{.low = 0.5, .high = 20000}.ticks() == Ticks{1, 10, 100, 1000, 10000});
}

TEST_CASE("an axis spans its values with air around them, and a lone value too") {
  const LogAxis wide = axis_around(Ticks{1, 100, 0, std::nan("")}, 0, 1);
  CHECK(wide.low < 1);
  CHECK(wide.low > 0.5);
  CHECK(wide.high > 100);
  const LogAxis lone = axis_around(Ticks{10}, 0, 100);
  CHECK(lone.ticks().size() >= 3);
  CHECK(std::abs(lone.place(10) - 50) < 1e-9);
}

TEST_CASE("zero lies on the lower end of an axis") {
  CHECK(LogAxis{.low = 1, .high = 10, .from = 50, .to = 0}.place(0) == 50);
}

TEST_CASE("the Pareto front holds the points that none beats in both") {
  const std::vector<ChartPoint> points = {
      {"slow and good", 8, 1}, {"beaten", 9, 2}, {"fast", 1, 5}, {"equal", 1, 5}, {"middle", 3, 3}};
  CHECK(pareto_front(points) == Flags{true, false, true, true, true});
}

TEST_CASE("of errors below the reference's accuracy the fastest is on the front") {
  const std::vector<ChartPoint> points = {{"fast", 1, 0.2}, {"slow", 2, 0.1}};
  CHECK(pareto_front(points) == Flags{true, true});
  CHECK(pareto_front(points, 0.3) == Flags{true, false});
}

TEST_CASE("labels of points that lie close together do not overlap") {
  const std::vector<LabelWish> wishes = {
      {{100, 100}, 80}, {{104, 101}, 80}, {{98, 103}, 80}, {{101, 96}, 80}, {{105, 105}, 80}};
  const auto placed = place_labels(wishes, 16, {0, 0, 400, 300}, {});
  for (std::size_t i = 0; i < placed.size(); ++i) {
    for (std::size_t k = i + 1; k < placed.size(); ++k) {
      const Rectangle &a = placed[i].box, &b = placed[k].box;
      CHECK((a.x1 <= b.x0 || b.x1 <= a.x0 || a.y1 <= b.y0 || b.y1 <= a.y0));
    }
  }
}

TEST_CASE("a chart shows points, intervals, front and floor") {
  Chart chart{"Speed & error", "time (ms)", "error (levels)", {}, 0.5, "too small to tell"};
  chart.points = {{"a<1>", 1, 20, 0.9, 1.2}, {"b", 10, 2}, {"c", 20, 8}, {"exact", 40, 0}};
  const std::string svg = scatter_chart(chart).text() + '\n';
  CHECK(svg == test::approved("chart.svg", svg));
}

TEST_CASE("what is below the reference's accuracy stands on it, marked, however small it is") {
  Chart chart{"Speed & error", "time (ms)", "error (levels)", {}, 1.5e-5, "too small to tell"};
  const auto heights = [&](std::vector<ChartPoint> points) {
    chart.points = std::move(points);
    const std::string svg = scatter_chart(chart).text();
    std::vector<std::string> found;
    for (std::size_t at = 0; (at = svg.find("<circle", at)) != std::string::npos; ++at) {
      const std::size_t y = svg.find("cy=\"", at) + 4;
      const std::size_t mark = svg.rfind("<g class=\"", at) + 10;
      found.push_back(svg.substr(mark, svg.find('"', mark) - mark) + ' ' + svg.substr(y, svg.find('"', y) - y));
    }
    return found;
  };
  const auto far = heights({{"a", 1, 20}, {"tiny", 10, 1e-12}, {"zero", 20, 0}, {"at it", 30, 1.5e-5}});
  REQUIRE(far.size() == 4);
  CHECK(far[0].starts_with("point "));
  CHECK(far[1].starts_with("point below "));
  const std::string floor = far[1].substr(far[1].rfind(' '));
  CHECK(far[2] == "point dominated below" + floor);
  CHECK(far[3] == "point dominated below" + floor);
  // The axis reaches no lower for them.
  CHECK(heights({{"a", 1, 20}, {"tiny", 10, 1e-5}, {"zero", 20, 1e-5}, {"at it", 30, 1.5e-5}}) == far);
}

TEST_CASE("a chart without points is no chart") { CHECK(scatter_chart({}).text().empty()); }

}  // namespace moire::report
