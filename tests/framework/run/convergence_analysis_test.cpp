#include "run/convergence_analysis.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include <moire/random.h>

#include "metrics/registry.h"

namespace moire::test {

using Catch::Approx;

namespace {

Settings settings(const std::string& theory = "") {
  Settings result(convergence_description.parameters);
  result.set("theory", theory);
  return result;
}

// Errors of 3 N^-3/4 with intervals of 10 %, and one contender of another family.
Results some_results() {
  Results results;
  results.scenes.emplace_back().name = "edge";
  for (int n : {2, 4, 8, 16}) {
    const std::string name = "jittered[n=" + std::to_string(n) + ",amount=1]";
    const double samples = n * n, error = 3 * std::pow(samples, -0.75);
    results.rows.push_back(
        {.scene = "edge", .sampler = name, .metric = "convergence.samples", .value = samples, .unit = ""});
    results.rows.push_back({"edge", name, "convergence.rmse", error, error / 1.05, error * 1.05, ""});
  }
  results.rows.push_back(
      {.scene = "edge", .sampler = "point", .metric = "convergence.samples", .value = 1, .unit = ""});
  results.rows.push_back({"edge", "point", "convergence.rmse", 0.5, 0.4, 0.6, ""});
  return results;
}

const Row* row(const Results& results, const std::string& sampler, const std::string& metric) {
  for (const Row& r : results.rows) {
    if (r.sampler == sampler && r.metric == metric) return &r;
  }
  return nullptr;
}

}  // namespace

TEST_CASE("a family is a contender without the settings that change its number of samples") {
  CHECK(family_of("jittered[n=4,amount=1]", "n points") == "jittered[amount=1]");
  CHECK(family_of("jittered[n=4]", "n points") == "jittered");
  CHECK(family_of("random[points=16]", "n points") == "random");
  CHECK(family_of("supersample[layout=grid,n=4,filter=mitchell]", "n") == "supersample[layout=grid,filter=mitchell]");
  CHECK(family_of("a label", "n") == "a label");
}

TEST_CASE("a power law is found again, with its constant") {
  std::vector<ErrorAt> errors;
  for (double n : {16.0, 64.0, 256.0})
    errors.push_back({n, 2 * std::pow(n, -0.5), 1.9 * std::pow(n, -0.5), 2.1 * std::pow(n, -0.5)});
  const auto law = fit_power_law(errors);
  REQUIRE(law);
  CHECK(law->slope == Approx(-0.5).epsilon(1e-12));
  CHECK(law->constant == Approx(2).epsilon(1e-12));
  // Equal intervals: 1.96 sd / sqrt(sum (x - mean)^2), sd that of log error.
  const double sd = std::log(2.1 / 1.9) / (2 * 1.96);
  CHECK(law->high - law->slope == Approx(1.96 * sd / std::sqrt(2 * std::pow(std::log(4), 2))).epsilon(1e-9));
  CHECK(constant_for(errors, -0.5) == Approx(2).epsilon(1e-12));
}

TEST_CASE("scatter beyond the intervals widens the slope's own") {
  // 1 % intervals about points that lie 20 % off the line, up and down.
  std::vector<ErrorAt> errors;
  double sign = 1;
  for (double n : {16.0, 32.0, 64.0, 128.0, 256.0}) {
    const double error = std::pow(n, -1) * (1 + 0.2 * sign);
    errors.push_back({n, error, error * 0.99, error * 1.01});
    sign = -sign;
  }
  const auto law = fit_power_law(errors);
  REQUIRE(law);
  CHECK(law->high - law->low > 0.1);
  CHECK(law->low < -1);
  CHECK(law->high > -1);
}

TEST_CASE("intervals of slopes hold the truth about as often as they say") {
  constexpr int trials = 400;
  int held = 0;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<ErrorAt> errors;
    for (int k = 0; k < 5; ++k) {
      // About normal: twelve uniform numbers less six have variance 1.
      double normal = -6;
      for (std::uint32_t u = 0; u < 12; ++u) normal += random({k, trial, 0, 11}, u, 0);
      const double n = 16 * std::pow(4, k), sd = 0.05, error = std::exp(-0.75 * std::log(n) + sd * normal);
      errors.push_back({n, error, error * std::exp(-1.96 * sd), error * std::exp(1.96 * sd)});
    }
    const auto law = fit_power_law(errors);
    held += law->low <= -0.75 && -0.75 <= law->high;
  }
  // At least 95 % (380, deviation 4.4), more since the scatter can only widen it.
  CHECK(held >= 380 - 4 * 4.4);
}

TEST_CASE("one size, or no error, has no slope") {
  CHECK_FALSE(fit_power_law({}));
  CHECK_FALSE(fit_power_law({{16, 0.1, 0.09, 0.11}}));
  CHECK_FALSE(fit_power_law({{16, 0.1, 0.09, 0.11}, {16, 0.2, 0.1, 0.3}}));
  CHECK_FALSE(fit_power_law({{16, 0, 0, 0}, {64, 0, 0, 0}}));
}

TEST_CASE("slopes, constants, a chart and statements come of the rows, and theory is put beside them") {
  Results results = some_results();
  analyse_convergence(settings("edge/jittered[amount=1]: -0.75 3.3"), results);
  CHECK(results.failures.empty());
  // From 16 samples on: n = 4, 8 and 16.
  REQUIRE(row(results, "jittered[amount=1]", "convergence.slope"));
  CHECK(row(results, "jittered[amount=1]", "convergence.slope")->value == Approx(-0.75).epsilon(1e-9));
  CHECK(row(results, "jittered[amount=1]", "convergence.constant")->value == Approx(3).epsilon(1e-9));
  CHECK(row(results, "point", "convergence.slope") == nullptr);
  REQUIRE(results.curves.size() == 1);
  CHECK(results.curves[0].points.size() == 4);
  REQUIRE(results.analyses.size() == 1);
  REQUIRE(results.analyses[0].statements.size() == 1);
  CHECK(results.analyses[0].statements[0] ==
        "edge / jittered[amount=1]: slope -0.750 (-0.775 to -0.725), theory -0.750: within the interval; constant "
        "3.000, theory 3.300 (-9.1 %).");
}

TEST_CASE("the samples of a family at an error lie on straight lines in logarithms, and on its law beyond the ends") {
  const std::vector<ErrorAt> family{{4, 0.5, 0, 0}, {16, 0.25, 0, 0}, {64, 0.125, 0, 0}};
  CHECK(samples_at(0.25, family) == Approx(16).epsilon(1e-12));
  CHECK(samples_at(0.25 / std::sqrt(2.0), family) == Approx(32).epsilon(1e-12));
  CHECK(samples_at(0.0625, family) == Approx(256).epsilon(1e-12));
  CHECK(samples_at(1, family) == Approx(1).epsilon(1e-12));
  CHECK(std::isnan(samples_at(0.1, {{4, 0.5, 0, 0}, {16, 0.5, 0, 0}})));
}

TEST_CASE("a contender saves what the family takes for its error") {
  Results results = some_results();
  Settings with = settings();
  with.set("against", std::string("jittered[amount=1]"));
  analyse_convergence(with, results);
  // jittered takes (3 / 0.5)^(4/3) samples for point's error of 0.5 with one.
  CHECK(row(results, "point", "convergence.saving")->value == Approx(std::pow(6, 4.0 / 3)).epsilon(1e-9));
  CHECK(row(results, "jittered[n=4,amount=1]", "convergence.saving")->value == Approx(1).epsilon(1e-9));

  with.set("against", std::string("sobol"));
  analyse_convergence(with, results);
  REQUIRE(results.failures.size() == 1);
  CHECK(results.failures[0].message == "against \"sobol\": no contender of this family ran on edge");
}

TEST_CASE("theory that cannot be read, or of nobody, is a failure") {
  Results results = some_results();
  analyse_convergence(settings("edge jittered -1; edge/nobody: -1"), results);
  REQUIRE(results.failures.size() == 2);
  CHECK(results.failures[0].message ==
        "theory: \"edge jittered -1\" cannot be read; write SCENE/FAMILY: SLOPE [CONSTANT]");
  CHECK(results.failures[1].message == "theory for edge/nobody: no such family with two sizes or more");
}

}  // namespace moire::test
