#include "report/numbers.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <vector>

namespace moire::report {

TEST_CASE("numbers for files are the shortest that read back the same") {
  CHECK(exact_text(0.1) == "0.1");
  CHECK(exact_text(400) == "400");
  CHECK(exact_text(1.0 / 3) == "0.3333333333333333");
  CHECK(exact_text(-std::nan("")) == "nan");
  CHECK(exact_text(-HUGE_VAL) == "-inf");
}

TEST_CASE("a column has as many decimals as three digits of its smallest number need") {
  CHECK(decimals_for(std::vector{12.5, 0.25, 0.0, std::nan("")}) == 3);
  CHECK(decimals_for(std::vector{12.5, 100.0}) == 1);
  CHECK(decimals_for(std::vector{731.0, 2.0}) == 0);
  CHECK(decimals_for(std::vector{1e-9}) == 4);
  CHECK(decimals_for({}) == 0);
}

TEST_CASE("numbers for people keep what counts") {
  CHECK(readable_text(12.5) == "12.5");
  CHECK(readable_text(0.0312) == "0.0312");
  CHECK(readable_text(0.00001) == "1.0e-05");
  CHECK(readable_text(0) == "0");
  CHECK(readable_text(2.5e12) == "2.5e+12");
  CHECK(readable_text(std::nan("")) == "nan");
}

}  // namespace moire::report
