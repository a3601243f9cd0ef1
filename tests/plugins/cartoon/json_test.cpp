// Drawings in JSON, and bad input.
#include <catch2/catch_test_macros.hpp>

#include "plugins/cartoon/svg_text.h"

namespace moire::test {
namespace {

std::string problem(std::string_view text) {
  return message_of([&] { cartoon::read_drawing(text, "a.json", cartoon::Unmodelled::refuse); });
}

// With one layer that has these members beside its colour.
std::string layer(std::string_view members) {
  return fmt::format("{{\"layers\": [{{\"color\": \"#ff0000\", {}}}]}}", members);
}

}  // namespace

TEST_CASE("layers in JSON, back to front") {
  const cartoon::Drawing drawing = read(
      "{\"layers\": [{\"color\": \"#102030\", \"contours\": [[[0, 0], [4, 0], [4, 3.5]], [[1, 1], [2, 1], [2, 2]]]},\n"
      "{\"contours\": [[[-1e2, 1], [2, 1], [2, 2]]], \"rule\": \"evenodd\", \"color\": \"#AABBCC\"},"
      "{\"contours\": [], \"rule\": \"nonzero\", \"color\": \"#000000\"}]}");
  CHECK(layers_of(drawing) ==
        "#102030 M 0,0 L 4,0 L 4,3.5 M 1,1 L 2,1 L 2,2\n#aabbcc evenodd M -100,1 L 2,1 L 2,2\n#000000 ");
  CHECK(drawing.view_box == cartoon::Box{-100, 0, 104, 3.5});
  CHECK_FALSE(drawing.background);
}

TEST_CASE("view box and background in JSON") {
  const cartoon::Drawing drawing = read(
      "{\"background\": \"#010203\", \"layers\": [{\"color\": \"#102030\", \"contours\": [[[0, 0], [4, 0], [4, 3]]]}],"
      "\"view_box\": [1, 2, 3, 4.5]}");
  CHECK(drawing.view_box == cartoon::Box{1, 2, 3, 4.5});
  CHECK(drawing.background == cartoon::Rgb{1, 2, 3});
}

TEST_CASE("mistakes in JSON drawings are told with line and place") {
  CHECK(problem("{}") == "a.json:1: has no \"layers\"; a drawing is {\"layers\": [...]}");
  CHECK(problem("{\"layer\": []}") == "a.json:1: has the key \"layer\"; known are layers, background and view_box");
  CHECK(problem("{\"layers\": []}") == "a.json: is an empty drawing; at least one filled shape is needed");
  CHECK(problem("{\"layers\":\n3}") == "a.json:2: layers: is 3; it is a list");
  CHECK(problem("{\"layers\": {}}") == "a.json:1: layers: is an object; it is a list");
  CHECK(problem("{\"layers\": [[]]}") ==
        "a.json:1: layers[0]: is a list; a layer is {\"color\": \"#rrggbb\", \"contours\": [...]}");
  CHECK(problem("{\"layers\": [{\"color\": \"#ff0000\"}]}") ==
        "a.json:1: layers[0]: has no \"contours\"; a layer has a color and contours");
  CHECK(problem("{\"layers\": [{\"contours\": []}]}") ==
        "a.json:1: layers[0]: has no \"color\"; a layer has a color and contours");
  CHECK(problem("{\"layers\": [], \"layers\": []}") == "a.json:1: layers: stands there twice; keep one of them");
  CHECK(problem("{\"background\": \"red\", \"layers\": []}") ==
        "a.json:1: background: is \"red\"; a colour is \"#rrggbb\"");
  CHECK(problem("{\"view_box\": [1, 2, 3], \"layers\": []}") ==
        "a.json:1: view_box: has 3 numbers; it is [x, y, width, height]");
  CHECK(problem("{\"view_box\": [1, 2, 3, null], \"layers\": []}") ==
        "a.json:1: view_box: is null; numbers are expected");

  CHECK(problem(layer("\"contours\": [], \"colour\": 1")) ==
        "a.json:1: layers[0]: has the key \"colour\"; known are color, rule and contours");
  CHECK(problem(layer("\"contours\": [], \"rule\": \"odd\"")) ==
        "a.json:1: layers[0].rule: is \"odd\"; known are nonzero and evenodd");
  CHECK(problem(layer("\"contours\": [], \"rule\": true")) ==
        "a.json:1: layers[0].rule: is true; known are nonzero and evenodd");
  CHECK(problem(layer("\"contours\": \"M 0 0\"")) == "a.json:1: layers[0].contours: is \"M 0 0\"; it is a list");
  CHECK(problem(layer("\"contours\": [3]")) == "a.json:1: layers[0].contours[0]: is 3; a contour is a list of points");
  CHECK(problem(layer("\"contours\": [[], [3]]")) == "a.json:1: layers[0].contours[1][0]: is 3; a point is [x, y]");
  CHECK(problem(layer("\"contours\": [[[1, 2], [3]]]")) ==
        "a.json:1: layers[0].contours[0][1]: has 1 numbers; a point is [x, y]");
  CHECK(problem(layer("\"contours\": [[[1, 2, 3]]]")) ==
        "a.json:1: layers[0].contours[0][0]: has 3 numbers; a point is [x, y]");
  CHECK(problem(layer("\"contours\": [[[1, \"2\"]]]")) ==
        "a.json:1: layers[0].contours[0][0]: is \"2\"; numbers are expected");
  CHECK(problem(layer("\"contours\": [[[1, 2],\n[1e10, 3]]]")) ==
        "a.json:2: layers[0].contours[0][1]: reaches coordinate 1e+10; at most 1e+09 can be drawn");
}

TEST_CASE("what is not JSON") {
  CHECK(problem("{\"layers\": [\n") ==
        "a.json:2: is not JSON: unexpected end of input; expected '[', '{', or a literal");
  CHECK(problem("{\"layers\": [],}").starts_with("a.json:1: is not JSON: unexpected '}'"));
  CHECK(problem("{\"layers\": []} x").starts_with("a.json:1: is not JSON: "));
  CHECK(problem("{\"layers\": [NaN]}").starts_with("a.json:1: is not JSON: invalid literal"));
  CHECK(problem(layer("\"contours\": [[[1e999, 0]]]")).starts_with("a.json:1: is not JSON: number overflow"));
  // Nothing may be nested deeper than a drawing is.
  CHECK(problem("{\"layers\": " + std::string(1000000, '[')) ==
        "a.json:1: layers[0]: is a list; a layer is {\"color\": \"#rrggbb\", \"contours\": [...]}");
}

}  // namespace moire::test
