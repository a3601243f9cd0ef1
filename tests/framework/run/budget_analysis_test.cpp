#include "run/budget_analysis.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include "metrics/registry.h"

namespace moire::test {

namespace {

const std::vector<Priced> all{{"fast", 1, 8}, {"middle", 3, 2}, {"exact", 9, 1e-7}, {"slow and exact", 20, 1e-8}};
constexpr double none = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("at equal time the least error is named") {
  CHECK(best_within_time(all, 1, none)->name == "fast");
  CHECK(best_within_time(all, 8.9, none)->name == "middle");
  CHECK(best_within_time(all, 100, none)->name == "slow and exact");
  CHECK_FALSE(best_within_time(all, 0.5, none));
}

TEST_CASE("errors below the reference's are equal, and the fastest of them is named") {
  CHECK(best_within_time(all, 100, 1e-6)->name == "exact");
}

TEST_CASE("at equal error the fastest is named, and none where nobody is as good") {
  CHECK(fastest_within_error(all, 10, none)->name == "fast");
  CHECK(fastest_within_error(all, 1, none)->name == "exact");
  CHECK_FALSE(fastest_within_error(all, 1e-9, none));
  CHECK(fastest_within_error(all, 1e-9, 1e-6)->name == "exact");  // no budget is finer than what can be told
}

TEST_CASE("budgets become statements and rows, and what is no number a failure") {
  Results results;
  results.scenes.emplace_back().name = "hill";
  for (const Priced& p : all) {
    results.contenders.emplace_back().name = p.name;
    results.rows.push_back(
        {.scene = "hill", .sampler = p.name, .metric = "error.rmse", .value = p.error, .unit = "levels"});
    results.rows.push_back(
        {.scene = "hill", .sampler = p.name, .metric = "speed.ms_per_frame", .value = p.ms, .unit = "ms"});
  }
  Settings settings(budget_description.parameters);
  settings.set("times", std::string("4 much"));
  settings.set("errors", std::string("2 1e-9"));
  analyse_budgets(settings, results);
  REQUIRE(results.analyses.size() == 1);
  CHECK(results.analyses[0].statements ==
        std::vector<std::string>{"hill, 4 x the fastest time: middle (3 ms, 2 levels).",
                                 "hill, 2 levels: middle (3 ms, 2 levels).", "hill, 1e-09 levels: none."});
  REQUIRE(results.failures.size() == 1);
  CHECK(results.failures[0].message == "budget.times: \"much\" is no number above 0");
}

}  // namespace moire::test
