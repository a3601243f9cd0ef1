// `moire run` with the passes that ask for more than one picture of a method, and for whole families of contenders.
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <set>

#include "app/program.h"
#include "app/tiny_experiment.h"
#include "report/json.h"

namespace moire::test {

namespace {

using Names = std::set<std::string>;

// Points with random numbers and without on a pattern of known frequencies.
std::string sampling_experiment() {
  return tiny_experiment(
      R"([{"type": "jittered", "n": [2, 4, 8]}, {"type": "supersample", "layout": "grid", "n": [2, 4, 8]}])",
      R"(["error", {"type": "spectrum", "pairs": 2}, "points", "speed", "budget",
          {"type": "convergence", "from_samples": 4, "against": "jittered"}])",
      R"([{"type": "pattern", "label": "waves", "kind": "wave", "frequency": 0.25,
           "second_frequency": 0.75, "second_amplitude": 0.1}])");
}

}  // namespace

TEST_CASE("methods with random numbers get pictures with others, those without none; families get slopes and charts") {
  Desk desk;
  desk.file("tiny/experiment.json", sampling_experiment());
  REQUIRE(desk.moire({"run", "tiny", "-o", "out"}).code == 0);
  const Results results = report::read_json(desk.path() / "out");
  CHECK(results.failures.empty());
  std::size_t random = 0, regular = 0;
  for (const Row& row : results.rows) {
    if (row.metric != "spectrum.noise") continue;
    const bool draws = row.sampler.starts_with("jittered");
    (draws ? random : regular) += 1;
    CAPTURE(row.sampler);
    CHECK((row.value > 0) == draws);
    CHECK((row.low < row.high) == draws);  // two pairs, with numbers of their own each
  }
  CHECK(random == 3);
  CHECK(regular == 3);

  Names slopes, savings, curves, titles;
  for (const Row& row : results.rows) {
    if (row.metric == "convergence.slope") slopes.insert(row.sampler);
    if (row.metric == "convergence.saving") savings.insert(row.sampler);
  }
  for (const CurveResult& curve : results.curves) curves.insert(curve.kind);
  for (const Analysis& analysis : results.analyses) titles.insert(analysis.title);
  CHECK(slopes == Names{"jittered", "supersample[layout=grid]"});
  CHECK(savings.size() == 6);
  CHECK(curves == Names{"convergence.rmse", "points.power", "spectrum.error_power"});
  CHECK(titles == Names{"Convergence", "At equal time and at equal error"});
  CHECK(desk.bytes("out/curves.csv").starts_with("scene,sampler,curve,x,y\r\n"));
  const std::string page = desk.bytes("out/report.html");
  CHECK(page.find("Error over samples") != std::string::npos);
}

TEST_CASE("the same experiment gives the same numbers again") {
  Desk desk;
  desk.file("tiny/experiment.json", sampling_experiment());
  REQUIRE(desk.moire({"run", "tiny", "-o", "one", "-j", "1"}).code == 0);
  REQUIRE(desk.moire({"run", "tiny", "-o", "two", "-j", "2"}).code == 0);
  const Results one = report::read_json(desk.path() / "one"), two = report::read_json(desk.path() / "two");
  const auto is_of_time = [](const Row& row) {
    return row.metric.starts_with("speed.") || row.metric.starts_with("budget.");
  };
  std::size_t compared = 0;
  for (const Row& row : one.rows) {
    if (is_of_time(row)) continue;
    for (const Row& other : two.rows) {
      if (row.scene != other.scene || row.sampler != other.sampler || row.metric != other.metric) continue;
      CAPTURE(row.sampler, row.metric);
      CHECK((row.value == other.value || (std::isnan(row.value) && std::isnan(other.value))));
      ++compared;
    }
  }
  CHECK(compared > 50);
}

}  // namespace moire::test
