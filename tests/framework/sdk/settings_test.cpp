// Settings follow their table, and what a plugin asks for wrongly is told to its author.
#include <moire/settings.h>

#include <catch2/catch_test_macros.hpp>

#include <moire/color.h>

#include "message_of.h"

using moire::Settings;
using moire::test::message_of;

namespace {

using namespace moire::parameter;

constexpr moire::Parameter table[] = {
    flag("hierarchy", true, "far voxels are averaged"),
    integer("n", 4, 1, 256, "points", "points of a column"),
    real("view.pitch_deg", -40.5, -90, 90, "degrees", "downward is negative"),
    choice("layout", "column", "column grid", "where points lie"),
    text("title", "untitled", "for pictures"),
    file("heights", "elevation"),
    color("sky", "#80b0ff", "above the horizon"),
};

}  // namespace

TEST_CASE("settings start with the table's defaults") {
  const Settings settings(table);
  CHECK(settings.flag("hierarchy"));
  CHECK(settings.integer("n") == 4);
  CHECK(settings.real("view.pitch_deg") == -40.5);
  CHECK(settings.text("layout") == "column");
  CHECK(settings.text("title") == "untitled");
  CHECK(settings.text("heights").empty());
  CHECK(settings.text("sky") == "#80b0ff");
  CHECK(settings.values().size() == std::size(table));
}

TEST_CASE("settings that were set are told apart") {
  Settings settings(table);
  settings.set("n", std::int64_t{16});
  CHECK(settings.integer("n") == 16);
  CHECK(settings != Settings(table));
}

TEST_CASE("asking for a setting that is not in the table names those that are") {
  constexpr moire::Parameter two[] = {table[1], table[3]};
  const std::string rest = "settings: the plugin asks for \"m\", which is not in its parameter table; that has ";
  CHECK(message_of([&] { Settings(two).integer("m"); }) == rest + "\"layout\", \"n\"");
  CHECK(message_of([&] { Settings(two).set("m", true); }) == rest + "\"layout\", \"n\"");
  CHECK(message_of([&] { Settings().flag("m"); }) == rest + "no parameters");
}

TEST_CASE("asking for a setting as another type names both types") {
  const Settings settings(table);
  const auto message = [](const char* name, const char* asked, const char* declared) {
    return std::string("settings: the plugin asks for \"") + name + "\" as " + asked +
           "; its parameter table declares " + declared;
  };
  CHECK(message_of([&] { settings.flag("n"); }) == message("n", "a flag", "an integer"));
  CHECK(message_of([&] { settings.real("n"); }) == message("n", "a real", "an integer"));
  CHECK(message_of([&] { settings.integer("hierarchy"); }) == message("hierarchy", "an integer", "a flag"));
  CHECK(message_of([&] { settings.text("view.pitch_deg"); }) == message("view.pitch_deg", "text", "a real"));
  CHECK(message_of([&] { settings.flag("layout"); }) == message("layout", "a flag", "text"));
}

TEST_CASE("colours are read as sRGB code values") {
  CHECK(moire::parse_color("#000000") == moire::Color{0, 0, 0});
  CHECK(moire::parse_color("#ffffff") == moire::Color{1, 1, 1});
  CHECK(moire::parse_color("#Ff8000") == moire::Color{1, static_cast<float>(moire::srgb_to_linear(128 / 255.0)), 0});
}

TEST_CASE("colours of another form are errors") {
  for (const std::string text : {"", "#", "red", "#12345", "#1234567", "1234567", "#12345g", "#-12345", "# 12345"}) {
    CHECK(message_of([&] { moire::parse_color(text); }) ==
          "color is \"" + text +
              "\"; it must be # and two hexadecimal digits each for red, green and blue, such as \"#80b0ff\"");
  }
}
