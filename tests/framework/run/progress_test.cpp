#include "run/progress.h"

#include <catch2/catch_test_macros.hpp>

TEST_CASE("durations are said as a person would, never too short") {
  using moire::rough_duration;
  CHECK(rough_duration(0) == "0 s");
  CHECK(rough_duration(0.2) == "1 s");
  CHECK(rough_duration(40) == "40 s");
  CHECK(rough_duration(89.5) == "90 s");
  CHECK(rough_duration(90) == "2 min");
  CHECK(rough_duration(180) == "3 min");
  CHECK(rough_duration(7500) == "2 h 5 min");
}
