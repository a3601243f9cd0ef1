// Which colour and rule a shape gets, through groups, attributes and styles.
#include <catch2/catch_test_macros.hpp>

#include "plugins/cartoon/svg_text.h"

namespace moire::test {
namespace {

constexpr std::string_view outline = "M 0,0 L 1,0 L 1,1";

// "#rrggbb", with " evenodd"; "" if the square is not painted. In `content` the path stands for @.
std::string square(std::string content) {
  const std::string path = "d='M 0 0 L 1 0 L 1 1'";
  content.replace(content.find('@'), 1, path);
  const cartoon::Drawing drawing = read(document(content + "<path d='M 5 5 L 6 5 L 6 6'/>"));
  if (drawing.layers.size() == 1) return "";
  std::string text = layers_of(drawing);
  text.resize(text.find(" M"));
  CHECK(shown(drawing) == outline);
  return text;
}

}  // namespace

TEST_CASE("fills are inherited, and a style wins over attributes") {
  CHECK(square("<path @/>") == "#000000");
  CHECK(square("<path fill='red' @/>") == "#ff0000");
  CHECK(square("<g fill='red'><path @/></g>") == "#ff0000");
  CHECK(square("<g fill='red'><g><path fill='blue' @/></g></g>") == "#0000ff");
  CHECK(square("<g fill='red'><path fill='inherit' @/></g>") == "#ff0000");
  CHECK(square("<path fill='red' style='fill:blue' @/>") == "#0000ff");
  CHECK(square("<path style='fill:blue' fill='red' @/>") == "#0000ff");
  CHECK(square("<path style=' fill : blue ! important ; ; stroke : none ' fill='red' @/>") == "#0000ff");
  CHECK(square("<g style='fill:blue'><path fill='red' @/></g>") == "#ff0000");
  CHECK(square("<a fill='red'><path @/></a>") == "#ff0000");
}

TEST_CASE("fill rules are inherited") {
  CHECK(square("<path fill-rule='evenodd' @/>") == "#000000 evenodd");
  CHECK(square("<g style='fill-rule:evenodd'><path @/></g>") == "#000000 evenodd");
  CHECK(square("<g fill-rule='evenodd'><path fill-rule='nonzero' @/></g>") == "#000000");
}

TEST_CASE("currentColor is the property color, black unless it is set") {
  CHECK(square("<path fill='currentColor' @/>") == "#000000");
  CHECK(square("<g color='red'><path fill='currentColor' @/></g>") == "#ff0000");
  CHECK(square("<g color='red' fill='currentColor'><path style='color:blue' @/></g>") == "#0000ff");
}

TEST_CASE("what is not seen is no layer") {
  CHECK(square("<path fill='none' @/>") == "");
  CHECK(square("<path fill='transparent' @/>") == "");
  CHECK(square("<path fill-opacity='0' @/>") == "");
  CHECK(square("<path opacity='0%' @/>") == "");
  CHECK(square("<g style='display:none' opacity='0.5'><path @/></g>") == "");
  CHECK(square("<g visibility='hidden'><path @/></g>") == "");
  CHECK(square("<g visibility='hidden'><path visibility='visible' @/></g>") == "#000000");
  CHECK(square("<defs><path @/></defs>") == "");
  CHECK(square("<symbol><path @/></symbol>") == "");
  CHECK(square("<clipPath><path @/></clipPath>") == "");
}

TEST_CASE("strokes that are not seen do no harm") {
  CHECK(square("<path stroke='none' stroke-width='3' @/>") == "#000000");
  CHECK(square("<path stroke='red' stroke-width='0' @/>") == "#000000");
  CHECK(square("<path style='stroke:#000;stroke-width:0pt' @/>") == "#000000");
  CHECK(square("<path stroke='red' stroke-opacity='0' @/>") == "#000000");
  CHECK(square("<path fill='red' opacity='1' fill-opacity='100%' clip-path='none' filter='none' @/>") == "#ff0000");
}

TEST_CASE("mistakes in styles are told with the property") {
  const auto problem = [](std::string_view attributes) {
    return problem_of(document(fmt::format("<path id='p' {} d='M 0 0 L 1 0 L 1 1'/>", attributes)));
  };
  CHECK(problem("fill='redd'") ==
        "a.svg:1: <path id=\"p\">: fill is \"redd\"; a colour is a name, \"#rrggbb\", \"#rgb\" "
        "or \"rgb(r, g, b)\"");
  CHECK(problem("style='fill-rule:odd'") ==
        "a.svg:1: <path id=\"p\">: fill-rule is \"odd\"; known are nonzero and evenodd");
  CHECK(problem("style='fill'") == "a.svg:1: <path id=\"p\">: style has \"fill\"; it takes \"property: value\"");
  CHECK(problem("opacity='half'") == "a.svg:1: <path id=\"p\">: opacity is \"half\"; an opacity is a number, 0 to 1");
  CHECK(problem("stroke-width='thin'") == "a.svg:1: <path id=\"p\">: stroke-width is \"thin\"; a width is a number");
}

}  // namespace moire::test
