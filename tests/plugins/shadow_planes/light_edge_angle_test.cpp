#include "light/edge_angle.h"

#include <catch2/catch_approx.hpp>
#include <limits>

using namespace shadow_planes;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

}  // namespace

TEST_CASE("the arctangent agrees with long double to three ulps", "[shadow_planes]") {
  double worst = 0;
  for (int k = -4000; k <= 4000; ++k) {
    const double t = std::exp2(0.01 * k);
    const auto truth = static_cast<double>(std::atan(static_cast<long double>(t)));
    worst = std::max(worst, std::abs(arctangent(t) - truth) / truth);
  }
  CHECK(worst <= 3 * epsilon);
  CHECK(arctangent(0) == 0);
  CHECK(arctangent(std::numeric_limits<double>::infinity()) == std::numbers::pi / 2);
}

TEST_CASE("angles over sines hold from almost parallel to almost opposite vectors", "[shadow_planes]") {
  double worst = 0;
  for (int k = 1; k < 2000; ++k) {
    // Denser towards both ends.
    const long double part = k / 2000.0L, bent = part * part * (3 - 2 * part);
    const long double angle = bent * std::numbers::pi_v<long double>;
    const long double sine = std::sin(angle), cosine = std::cos(angle);
    const auto squared = static_cast<double>(sine * sine), dot = static_cast<double>(cosine);
    // Of the rounded arguments, which near pi say the angle better than `angle` itself.
    const long double kept = std::sqrt(static_cast<long double>(squared));
    const auto truth = static_cast<double>(std::atan2(kept, static_cast<long double>(dot)) / kept);
    worst = std::max(worst, std::abs(angle_over_sine(squared, dot) - truth) / truth);
  }
  CHECK(worst <= 6 * epsilon);
}

TEST_CASE("an edge of length zero, or seen end to end, has a defined angle", "[shadow_planes]") {
  CHECK(angle_over_sine(0, 4) == 0.25);
  CHECK(angle_over_sine(0, -4) == 0);
  CHECK(angle_over_sine(0, 0) == 0);
}
