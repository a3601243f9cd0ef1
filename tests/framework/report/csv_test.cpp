#include "report/csv.h"

#include <catch2/catch_test_macros.hpp>

#include "framework/report/approved.h"
#include "framework/report/sample_results.h"

namespace moire::test {

TEST_CASE(
    "results.csv has a line a number, quoted where a comma or a quote stands, bounds empty where there are none") {
  const std::string text = report::csv_text(sample_results());
  CHECK(text == approved("results.csv", text));
}

}  // namespace moire::test
