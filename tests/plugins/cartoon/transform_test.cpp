// SVG's transforms against places worked out by hand.
#include <catch2/catch_test_macros.hpp>
#include <cmath>

#include <fmt/format.h>

#include "message_of.h"
#include "reading/transform.h"

namespace moire::test {
namespace {

std::string moved(std::string_view transform, Point p = {3, 4}) {
  const Point q = cartoon::parse_transform(transform)(p);
  return fmt::format("{:.12g} {:.12g}", q.x + 0.0, q.y + 0.0);
}

std::string problem(std::string_view transform) {
  return message_of([&] { cartoon::parse_transform(transform); });
}

}  // namespace

TEST_CASE("each transform of SVG moves a point as its matrix says") {
  CHECK(moved("") == "3 4");
  CHECK(moved("none") == "3 4");
  CHECK(moved("matrix(1 2 3 4 5 6)") == "20 28");
  CHECK(moved("translate(10)") == "13 4");
  CHECK(moved("translate(10, 20)") == "13 24");
  CHECK(moved("scale(2)") == "6 8");
  CHECK(moved("scale(2 -3)") == "6 -12");
  CHECK(moved("rotate(90)") == "-4 3");
  CHECK(moved("rotate(-90)") == "4 -3");
  CHECK(moved("rotate(180, 3, 0)") == "3 -4");
  CHECK(moved("rotate(90 1 1)") == "-2 3");
  CHECK(moved("skewX(45)") == "7 4");
  CHECK(moved("skewY(45)") == "3 7");
  CHECK(moved("rotate(30)", {2, 0}) == fmt::format("{:.12g} 1", std::sqrt(3)));
}

TEST_CASE("of several transforms the last one is applied first") {
  CHECK(moved("translate(10,0) scale(2)") == "16 8");
  CHECK(moved("scale(2),translate(10,0)") == "26 8");
  CHECK(moved(" rotate(90)\n translate( 1 , 0 ) ") == "-4 4");
}

TEST_CASE("right angles turn without rounding") {
  for (int quarter = -8; quarter <= 8; ++quarter) {
    const Affine turn = cartoon::parse_transform(fmt::format("rotate({})", 90 * quarter));
    CHECK(std::abs(turn.xx) + std::abs(turn.xy) == 1);
    CHECK(turn.xx * turn.xy == 0);
  }
}

TEST_CASE("mistakes in transforms") {
  CHECK(problem("turn(3)") == "has the function \"turn\"; known are matrix, translate, scale, rotate, skewX and skewY");
  CHECK(problem("scale 3") ==
        "has the function \"scale 3\"; known are matrix, translate, scale, rotate, skewX and skewY");
  CHECK(problem("scale") == "has no bracket after \"scale\"");
  CHECK(problem("scale(") == "has the end in \"scale\"; it takes s, or sx sy");
  CHECK(problem("scale()") == "has 0 numbers in \"scale\"; it takes s, or sx sy");
  CHECK(problem("rotate(1 2)") == "has 2 numbers in \"rotate\"; it takes angle, or angle cx cy");
  CHECK(problem("matrix(1 2 3 4 5 6 7)") == "has \"7)\" in \"matrix\"; it takes a b c d e f");
  CHECK(problem("translate(x)") == "has \"x)\" in \"translate\"; it takes tx, or tx ty");
  CHECK(problem("translate(1e10)") == "has the number 1e+10 in \"translate\"; at most 1e+09 can be drawn");
  CHECK(problem("scale(0)") == "cannot be inverted (its determinant is 0); nothing would be left of the drawing");
  CHECK(problem("matrix(1 2 2 4 0 0)") ==
        "cannot be inverted (its determinant is 0); nothing would be left of the drawing");
}

}  // namespace moire::test
