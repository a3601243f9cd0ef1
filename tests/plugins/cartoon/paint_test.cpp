// CSS's colours and SVG's paints.
#include <algorithm>
#include <catch2/catch_test_macros.hpp>

#include <fmt/format.h>

#include "message_of.h"
#include "reading/named_colors.h"
#include "reading/paint.h"

namespace moire::test {
namespace {

std::string paint(std::string_view text) {
  const cartoon::Paint paint = cartoon::parse_paint(text);
  switch (paint.kind) {
    case cartoon::Paint::Kind::none:
      return "none";
    case cartoon::Paint::Kind::current:
      return "current";
    case cartoon::Paint::Kind::unmodelled:
      return fmt::format("unmodelled {}", paint.text);
    default:
      return fmt::format("#{:02x}{:02x}{:02x}", paint.rgb.r, paint.rgb.g, paint.rgb.b);
  }
}

}  // namespace

TEST_CASE("paints in all notations") {
  CHECK(paint("none") == "none");
  CHECK(paint(" Transparent ") == "none");
  CHECK(paint("#1aF") == "#11aaff");
  CHECK(paint("#12aBeF") == "#12abef");
  CHECK(paint("rgb(1, 20,255)") == "#0114ff");
  CHECK(paint("RGB( 1 20 300 )") == "#0114ff");
  CHECK(paint("rgb(0%,50%,100%)") == "#0080ff");
  CHECK(paint("rgb(-5, 1.5, 254.6)") == "#0002ff");
  CHECK(paint("Red") == "#ff0000");
  CHECK(paint("lightgoldenrodyellow") == "#fafad2");
  CHECK(paint("currentColor") == "current");
  CHECK(paint("#CD853F icc-color(acmecmyk, 0.11, 0.48, 0.83, 0.00)") == "#cd853f");
  CHECK(paint("url(#gradient) red") == "unmodelled url(#gradient) red");
  CHECK(paint("rgba(1, 2, 3, 0.5)") == "unmodelled rgba(1, 2, 3, 0.5)");
  CHECK(paint("#12345678") == "unmodelled #12345678");
}

TEST_CASE("what is no paint") {
  for (const std::string_view text : {"", "redd", "#12", "#12345g", "12ab34", "rgb(1,2)", "rgb(1,2%,3)", "rgb(1,2,3"}) {
    CAPTURE(text);
    const std::string found = text.empty() ? "the end" : fmt::format("\"{}\"", text);
    CHECK(message_of([&] { paint(text); }) ==
          fmt::format("is {}; a colour is a name, \"#rrggbb\", \"#rgb\" or \"rgb(r, g, b)\"", found));
  }
}

TEST_CASE("the names of colours are in alphabetical order, so that each is found") {
  CHECK(std::ranges::is_sorted(cartoon::named_colors, {}, &cartoon::NamedColor::name));
  for (const auto& [name, rgb] : cartoon::named_colors) CHECK(paint(name) == fmt::format("#{:06x}", rgb));
  CHECK(std::size(cartoon::named_colors) == 148);
}

}  // namespace moire::test
