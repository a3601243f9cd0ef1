#include "report/summary.h"

#include <catch2/catch_test_macros.hpp>

#include "framework/report/approved.h"
#include "framework/report/sample_results.h"

namespace moire::test {

TEST_CASE("the summary shows the main metrics, what is best of them, what cannot be told and what failed") {
  Results results = sample_results();
  results.interrupted = true;
  const std::string text = report::summary_text(results);
  CHECK(text == approved("summary.txt", text));
}

TEST_CASE("a scene without numbers is listed all the same") {
  Results results;
  results.scenes.emplace_back().name = "empty plain";
  results.contenders.emplace_back().name = "point";
  CHECK(report::summary_text(results) == "empty plain\n\n\n  point\n\n");
}

}  // namespace moire::test
