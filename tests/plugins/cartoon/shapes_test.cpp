// The basic shapes of SVG against outlines worked out by hand.
#include <catch2/catch_test_macros.hpp>

#include "plugins/cartoon/svg_text.h"

namespace moire::test {

TEST_CASE("rectangles, with square and with round corners") {
  CHECK(layers("<rect x='1' y='2' width='3' height='4'/>") == "#000000 M 1,2 L 4,2 L 4,6 L 1,6");
  CHECK(layers("<rect width='3' height='4'/>") == "#000000 M 0,0 L 3,0 L 3,4 L 0,4");
  const std::string round = layers(
      "<path d='M 3 2 L 9 2 A 2 1 0 0 1 11 3 L 11 7 A 2 1 0 0 1 9 8 L 3 8 A 2 1 0 0 1 1 7 L 1 3 A 2 1 0 0 1 3 2'/>");
  CHECK(layers("<rect x='1' y='2' width='10' height='6' rx='2' ry='1'/>") == round);
  // One radius stands for both; none is longer than half a side.
  const auto rect = [](std::string_view radii) {
    return layers(fmt::format("<rect x='1' y='2' width='10' height='6' {}/>", radii));
  };
  CHECK(rect("rx='2'") == rect("rx='2' ry='2'"));
  CHECK(rect("ry='2' rx='auto'") == rect("rx='2' ry='2'"));
  CHECK(rect("rx='50' ry='40'") == rect("rx='5' ry='3'"));
  CHECK(rect("rx='0' ry='2'") == rect(""));
}

TEST_CASE("circles and ellipses") {
  CHECK(layers("<circle cx='1' cy='2' r='3'/>") == "#000000 M 4,2 A 1,2 3,0 0,3 0,6.28319 4,2");
  CHECK(layers("<ellipse cx='1' cy='2' rx='3' ry='4'/>") == "#000000 M 4,2 A 1,2 3,0 0,4 0,6.28319 4,2");
  CHECK(layers("<ellipse rx='3'/>") == "#000000 M 3,0 A 0,0 3,0 0,3 0,6.28319 3,0");
}

TEST_CASE("polygons and polylines are filled alike") {
  CHECK(layers("<polygon points='1,2 3,4 5-6'/>") == "#000000 M 1,2 L 3,4 L 5,-6");
  CHECK(layers("<polyline points=' 1 2,3 4 , 5,6 '/>") == "#000000 M 1,2 L 3,4 L 5,6");
}

TEST_CASE("shapes without size paint nothing") {
  const std::string square = "<rect width='1' height='1'/>";
  for (const std::string_view nothing :
       {"<rect width='0' height='2'/>", "<rect width='2'/>", "<circle r='0'/>", "<circle/>", "<ellipse rx='0' ry='1'/>",
        "<polygon points=''/>", "<polygon/>", "<path/>", "<path d='M 1 2'/>", "<polygon points='1 2'/>"}) {
    CAPTURE(nothing);
    CHECK(layers(std::string(nothing) + square) == "#000000 M 0,0 L 1,0 L 1,1 L 0,1");
  }
}

TEST_CASE("lengths in units are user units at 96 to the inch") {
  CHECK(layers("<rect x='1in' y='3pt' width='25.4mm' height='2pc'/>") ==
        layers("<rect x='96' y='4' width='96' height='32'/>"));
  CHECK(layers("<rect width='1px' height='2.54cm'/>") == layers("<rect width='1' height='96'/>"));
}

TEST_CASE("mistakes in shapes are told with the attribute") {
  const auto problem = [](std::string_view element) { return problem_of(document(element)); };
  CHECK(problem("<rect width='-1' height='2'/>") == "a.svg:1: <rect>: width is -1; a size is at least 0");
  CHECK(problem("<rect width='5%' height='2'/>") ==
        "a.svg:1: <rect>: width is \"5%\"; a length is a number, or one with px, in, cm, mm, pt or pc");
  CHECK(problem("<circle id='c' r='x'/>") ==
        "a.svg:1: <circle id=\"c\">: r is \"x\"; a length is a number, or one with px, in, cm, mm, pt or pc");
  CHECK(problem("<rect x='2e9' width='1' height='2'/>") == "a.svg:1: <rect>: x is \"2e9\"; at most 1e+09 can be drawn");
  CHECK(problem("<polygon points='1 2 3'/>") == "a.svg:1: <polygon>: points has 3 numbers; x and y take turns");
  CHECK(problem("<polygon points='1 2 3,x'/>") ==
        "a.svg:1: <polygon>: points, character 7: has \"x\"; x and y take turns");
  CHECK(problem("<polygon points='1 2 1e10 4'/>") ==
        "a.svg:1: <polygon>: reaches coordinate 1e+10; at most 1e+09 can be drawn");
}

}  // namespace moire::test
