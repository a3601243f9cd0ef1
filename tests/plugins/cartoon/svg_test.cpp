// SVG documents: groups and transforms, what cannot be shown, and bad input.
#include <catch2/catch_test_macros.hpp>

#include "plugins/cartoon/svg_text.h"

namespace moire::test {
namespace {

std::string repeated(std::string_view text, int times) {
  std::string all;
  for (int k = 0; k < times; ++k) all += text;
  return all;
}

}  // namespace

TEST_CASE("layers stand back to front, in nested groups with transforms") {
  CHECK(layers(
            "<g transform='translate(10,0)'><path d='M0 0L1 0L1 1'/><g transform='scale(2)'>"
            "<path transform='rotate(90)' fill='red' d='M0 0L1 0L1 1'/></g></g><path fill='lime' d='M0 0L1 0L1 1'/>") ==
        "#000000 M 10,0 L 11,0 L 11,1\n#ff0000 M 10,0 L 10,2 L 8,2\n#00ff00 M 0,0 L 1,0 L 1,1");
}

TEST_CASE("metadata, editors' own elements and prefixes do not matter") {
  CHECK(
      layers(
          "<metadata><rdf:RDF><x:y/></rdf:RDF></metadata><title>T</title><desc>D</desc>"
          "<sodipodi:namedview bordercolor='#666' opacity='0.5'/><defs><linearGradient id='g'/></defs><style> </style>"
          "<svg:path inkscape:label='a' d='M0 0L1 0L1 1'/>") == "#000000 M 0,0 L 1,0 L 1,1");
}

TEST_CASE("the view box is the document's, or the box around what is painted") {
  CHECK(read("<svg viewBox=' 1,2 3 4 '><path d='M0 0L1 0L1 1'/></svg>").view_box == cartoon::Box{1, 2, 3, 4});
  // What is not painted does not count, and curves count as far as they go, not their control points.
  CHECK(read("<svg width='50mm' height='3'><path fill='none' d='M-9 0L1 0L1 1'/><path d='M0 0Q2 4 4 0z'/></svg>")
            .view_box == cartoon::Box{0, 0, 4, 2});
  CHECK(read("<svg><circle cx='1' cy='2' r='3'/></svg>").view_box == cartoon::Box{-2, -1, 6, 6});
}

TEST_CASE("what cannot be shown is listed with element and line, and refused") {
  const std::string text =
      "<svg viewBox='0 0 9 9'>\n"
      "<style>path { fill: red }</style>\n"
      "<path id='outlined' stroke='#000' d='M0 0L1 0L1 1'/>\n"
      "<path id='shaded' fill='url(#g)' d='M0 0L1 0L1 1'/>\n"
      "<g opacity='.5'><path d='M0 0L1 0L1 1'/></g>\n"
      "<path fill-opacity='.25' d='M0 0L1 0L1 1'/>\n"
      "<g clip-path='url(#c)' mask='url(#m)'/><g filter='url(#f)'/>\n"
      "<text>T</text><image/><use/><svg/><switch/><foreignObject/>\n"
      "<line x2='3' stroke='red'/><path d='M0 0L1 0L1 1'><animate/></path>\n"
      "<path style='mix-blend-mode:multiply;transform:none' d='M0 0L1 0L1 1'/>\n"
      "<path style='&st0;' d='M0 0L1 0L1 1'/>\n"
      "<path fill='#12345678' d='M0 0L1 0L1 1'/>\n"
      "<path id='plain' fill='lime' d='M2 0L3 0L3 1'/>\n"
      "</svg>";
  CHECK(problem_of(text) ==
        "a.svg:2: <style>\n"
        "a.svg:3: <path id=\"outlined\">: stroke #000\n"
        "a.svg:4: <path id=\"shaded\">: fill url(#g)\n"
        "a.svg:5: <g>: opacity .5\n"
        "a.svg:6: <path>: fill-opacity 0.25\n"
        "a.svg:7: <g>: clip-path url(#c)\n"
        "a.svg:7: <g>: mask url(#m)\n"
        "a.svg:7: <g>: filter url(#f)\n"
        "a.svg:8: <text>\n"
        "a.svg:8: <image>\n"
        "a.svg:8: <use>\n"
        "a.svg:8: <svg>\n"
        "a.svg:8: <switch>\n"
        "a.svg:8: <foreignObject>\n"
        "a.svg:9: <line>: stroke red\n"
        "a.svg:9: <animate>\n"
        "a.svg:10: <path>: mix-blend-mode multiply\n"
        "a.svg:10: <path>: transform in style\n"
        "a.svg:11: <path>: entity &st0; in style\n"
        "a.svg:12: <path>: fill #12345678\n"
        "a.svg: has 20 parts that cannot be shown (listed above); \"unsupported\": \"skip\" leaves them out");
  // The stroke is left out and what is filled stays; so does what only would move.
  CHECK(layers_of(read(text, cartoon::Unmodelled::skip)) ==
        "#000000 M 0,0 L 1,0 L 1,1\n#000000 M 0,0 L 1,0 L 1,1\n#00ff00 M 2,0 L 3,0 L 3,1");
  CHECK(
      problem_of(document("<use/><path d='M0 0L1 0L1 1'/>")) ==
      "a.svg:1: <use>\na.svg: has 1 part that cannot be shown (listed above); \"unsupported\": \"skip\" leaves it out");
}

TEST_CASE("long lists of what cannot be shown end with their number") {
  const std::string problem = problem_of(document(repeated("<use/>", 1234)));
  CHECK(problem.starts_with("a.svg:1: <use>\na.svg:1: <use>\n"));
  CHECK(
      problem.ends_with("<use>\na.svg: and 234 more\na.svg: has 1234 parts that cannot be shown (listed above); "
                        "\"unsupported\": \"skip\" leaves them out"));
}

TEST_CASE("what is not well-formed XML, or not SVG") {
  CHECK(problem_of("") == "a.svg: begins with the end; an SVG drawing begins with \"<\", a JSON one with \"{\"");
  CHECK(problem_of("PNG") == "a.svg: begins with \"PNG\"; an SVG drawing begins with \"<\", a JSON one with \"{\"");
  CHECK(problem_of("<svg>\n<g>\n</svg>") == "a.svg:3: is not XML (Start-end tags mismatch); an SVG drawing is");
  CHECK(problem_of("<svg>\n<path d='M0 0").starts_with("a.svg:2: is not XML ("));
  CHECK(problem_of("<html/>") == "a.svg:1: begins with <html>; an SVG drawing begins with <svg>");
  CHECK(problem_of("<!-- only this -->") == "a.svg:1: is not XML (No document element found); an SVG drawing is");
  CHECK(problem_of("\x1f\x8b\x08") == "a.svg: is compressed; unpack it first (gunzip -S .svgz)");
  CHECK(problem_of("\xff\xfe<") == "a.svg: is UTF-16; save it as UTF-8");
  CHECK(layers_of(read("\xef\xbb\xbf<?xml version='1.0'?><svg><path d='M0 0L1 0L1 1'/></svg>")) ==
        "#000000 M 0,0 L 1,0 L 1,1");
}

TEST_CASE("entities of a document type are not expanded, so that they cannot explode") {
  std::string bomb = "<!DOCTYPE svg [<!ENTITY a0 'M0 0L1 0L1 1'>";
  for (int k = 1; k < 60; ++k) bomb += fmt::format("<!ENTITY a{0} '&a{1};&a{1};&a{1};&a{1};'>", k, k - 1);
  CHECK(
      problem_of(bomb + "]><svg><path d='&a59;'/></svg>") ==
      "a.svg:1: <path>: d, character 1: has \"&a59;\" where a command is expected; commands are MmLlHhVvCcSsQqTtAaZz");
}

TEST_CASE("deep nesting is refused before it exhausts anything") {
  const std::string path = "<path d='M0 0L1 0L1 1'/>";
  const auto nested = [&](int depth) { return document(repeated("<g>", depth) + path + repeated("</g>", depth)); };
  CHECK(layers_of(read(nested(1000))) == "#000000 M 0,0 L 1,0 L 1,1");
  CHECK(problem_of(nested(1001)) == "a.svg:1: <g>: is nested more than 1000 levels deep");
  CHECK(problem_of(nested(1000000)) == "a.svg:1: <g>: is nested more than 1000 levels deep");
}

TEST_CASE("mistakes are told with line, element and place") {
  CHECK(problem_of("<svg>\n\n<path id='eye' d='M 1 2 L 3 Z'/></svg>") ==
        "a.svg:3: <path id=\"eye\">: d, character 11: \"L\" has 1 of 2 numbers (then \"Z\"); it takes x y");
  CHECK(problem_of("<svg>\n<g transform='scale(0)'/></svg>") ==
        "a.svg:2: <g>: transform cannot be inverted (its determinant is 0); nothing would be left of the drawing");
  // Each transform may be small, and their product still large.
  CHECK(problem_of("<svg><g transform='scale(1e6)'><rect transform='scale(1e6)' width='1' height='1'/></g></svg>") ==
        "a.svg:1: <rect>: reaches coordinate 1e+12; at most 1e+09 can be drawn");
}

TEST_CASE("drawings that are empty or cannot be fitted into an image") {
  const std::string empty = "a.svg: is an empty drawing; at least one filled shape is needed";
  CHECK(problem_of(document("")) == empty);
  CHECK(problem_of(document("<path fill='none' d='M0 0L1 0L1 1'/>")) == empty);
  CHECK(problem_of(document("<use/>"), cartoon::Unmodelled::skip) == empty);
  const auto box = [](std::string_view view_box) {
    return problem_of(fmt::format("<svg viewBox='{}'><path d='M0 0L1 0L1 1'/></svg>", view_box));
  };
  const std::string sides = "; its sides are 1e-09 to 2e+09, as far from the origin at most";
  CHECK(box("0 0 0 5") == "a.svg: the view box is 0 x 5 at (0, 0)" + sides);
  CHECK(box("0 0 -1 5") == "a.svg: the view box is -1 x 5 at (0, 0)" + sides);
  CHECK(box("1e10 0 1 5") == "a.svg: the view box is 1 x 5 at (1e+10, 0)" + sides);
  CHECK(box("0 0 1e999 5") == "a.svg: the view box is inf x 5 at (0, 0)" + sides);
  CHECK(box("0 0 1") == "a.svg:1: <svg>: viewBox is \"0 0 1\"; it takes x y width height");
  CHECK(box("0 0 1 2 3") == "a.svg:1: <svg>: viewBox is \"0 0 1 2 3\"; it takes x y width height");
  CHECK(problem_of("<svg><path d='M0 0L1 0'/></svg>") ==
        "a.svg: the box around all that is drawn is 1 x 0 at (0, 0)" + sides);
}

}  // namespace moire::test
