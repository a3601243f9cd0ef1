#include "run/detail_window.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <vector>

namespace moire {

using Window = std::array<int, 4>;

TEST_CASE("the worst window is the one with the greatest sum") {
  std::vector<double> error(10 * 6, 0.0);
  error[3 * 10 + 7] = 5;  // alone, and large
  error[0] = error[1] = error[10] = 2;
  CHECK(worst_window(error, {10, 6}, 2) == Window{0, 0, 2, 2});
  error[3 * 10 + 7] = 7;
  CHECK(worst_window(error, {10, 6}, 2) == Window{6, 2, 2, 2});
}

TEST_CASE("what is not finite does not choose the window") {
  std::vector<double> error(8 * 8, 0.0);
  error[0] = std::nan("");
  error[1] = HUGE_VAL;
  error[63] = 1;
  CHECK(worst_window(error, {8, 8}, 1) == Window{7, 7, 1, 1});
}

TEST_CASE("a window is never larger than the image") {
  CHECK(worst_window(std::vector<double>(3 * 2, 1.0), {3, 2}) == Window{0, 0, 3, 2});
  CHECK(middle_window({3, 200}) == Window{0, 76, 3, 48});
}

}  // namespace moire
