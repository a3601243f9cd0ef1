#include "weights/cosine.h"

#include <catch2/catch_test_macros.hpp>

#include "numbers.h"

namespace moire::test {

TEST_CASE("the cosine without branches is right to rounding") {
  Numbers numbers;
  for (int k = 0; k < 20000; ++k) {
    const double t = k < 100 ? (k - 50) / 8.0 : numbers.between(-3, 3);
    CAPTURE(t);
    const long double exact = std::cos(2 * std::numbers::pi_v<long double> * static_cast<long double>(t));
    CHECK(std::abs(pattern::cosine(t) - static_cast<double>(exact)) < 4e-16);
  }
  CHECK(pattern::cosine(0) == 1);
  CHECK(pattern::cosine(0.25) == 0);
  CHECK(pattern::cosine(1e6 + 0.5) == -1);
}

}  // namespace moire::test
