#include "sampling/lookups/mip_level.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <limits>

namespace moire::test {

TEST_CASE("a mip level is the binary logarithm of a length, to 1e-7, and exact on powers of two") {
  for (int k = 0; k <= 30; ++k) CHECK(mip_level(std::exp2(2 * k), 0, 40) == k);
  double farthest = 0;
  for (double x = 1; x < 1e12; x *= 1.00037) {
    farthest = std::max(farthest, std::abs(mip_level(x, 0, 40) - std::log2(x) / 2));
  }
  CHECK(farthest <= 1e-7);
  CHECK(farthest > 0);
}

TEST_CASE("lengths up to a texel are of level 0, and the bias counts from there") {
  for (const double squared : {0.0, std::numeric_limits<double>::denorm_min(), 0.25, 1.0}) {
    CHECK(mip_level(squared, 0, 9) == 0);
    CHECK(mip_level(squared, 1.5, 9) == 1.5);
    CHECK(mip_level(squared, -2, 9) == 0);
  }
  CHECK(mip_level(64, -1, 9) == 2);
}

TEST_CASE("levels end at the coarsest, which is that of lengths that nobody knows") {
  CHECK(mip_level(1e300, 0, 9) == 9);
  CHECK(mip_level(1, 16, 9) == 9);
  CHECK(mip_level(1e300, 0, 0) == 0);
  for (const double unknown : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    CHECK(mip_level(unknown, -3, 9) == 9);
  }
}

}  // namespace moire::test
