// Lines and circles from JSON.
#include "primitives/world/reading.h"

#include <catch2/catch_test_macros.hpp>

#include "message_of.h"
#include "support/plugins.h"
#include "temporary_folder.h"

namespace moire::test {
namespace {

const primitives::Style style{parse_color("#102030"), 1.5, Cap::square};

primitives::Picture read(std::string_view text) { return read_picture(Document(text, "a.json"), style); }

// Of the only primitive.
std::string problem_with(std::string_view members) {
  return message_of([&] { read(fmt::format("{{\"primitives\": [\n{{{}}}]}}", members)); });
}

}  // namespace

TEST_CASE("lines and circles are read with all that they may have") {
  const auto picture = read(R"({"background": "#ff0000", "primitives": [
    {"type": "line", "from": [1, -2], "to": [3e2, 4.5], "width": 2, "cap": "round", "color": "#00ff00",
     "velocity": [5, 6], "spin_deg": -7},
    {"type": "circle", "center": [8, 9], "radius": 10, "width": 11, "color": "#0000ff", "velocity": [12, 13]}]})");
  CHECK(picture.background == Color{1, 0, 0});
  REQUIRE(picture.primitives.size() == 2);
  const auto& line = std::get<LineCurve>(picture.primitives[0].curve);
  CHECK(line.from == Point{1, -2});
  CHECK(line.to == Point{300, 4.5});
  CHECK(line.width == 2);
  CHECK(line.cap == Cap::round);
  CHECK(line.color == Color{0, 1, 0});
  CHECK(picture.primitives[0].motion.velocity == Point{5, 6});
  CHECK(picture.primitives[0].motion.spin_deg == -7);
  const auto& circle = std::get<CircleCurve>(picture.primitives[1].curve);
  CHECK(circle.center == Point{8, 9});
  CHECK(circle.radius == 10);
  CHECK(circle.width == 11);
  CHECK(circle.color == Color{0, 0, 1});
  CHECK(picture.primitives[1].motion.velocity == Point{12, 13});
}

TEST_CASE("what primitives do not say is said by the settings") {
  const auto picture = read(R"({"primitives": [{"type": "line", "from": [0, 0], "to": [1, 0]},
                                               {"type": "circle", "center": [0, 0], "radius": 1}]})");
  CHECK_FALSE(picture.background);
  const auto& line = std::get<LineCurve>(picture.primitives[0].curve);
  CHECK(line.width == 1.5);
  CHECK(line.cap == Cap::square);
  CHECK(line.color == style.color);
  const auto& circle = std::get<CircleCurve>(picture.primitives[1].curve);
  CHECK(circle.width == 1.5);
  CHECK(circle.color == style.color);
  CHECK(picture.primitives[1].motion.velocity == Point{});
}

TEST_CASE("a picture may be empty") { CHECK(read("{\"primitives\": []}").primitives.empty()); }

TEST_CASE("a wrong primitive is refused with its line and path") {
  const auto problem = [](std::string_view text) { return message_of([&] { read(text); }); };
  CHECK(problem("{}") == "a.json:1: has no \"primitives\"; it needs one");
  CHECK(problem("[]") == "a.json:1: is a list; an object is expected");
  CHECK(problem("{\"primitives\": 3}") == "a.json:1: primitives: is 3; a list is expected");
  CHECK(problem("{\"primitives\": [],\n\"backround\": 3}") ==
        "a.json:2: backround: unknown key; did you mean \"background\"? known are background, primitives");
  CHECK(problem("{\"primitives\": [],\n\"background\": \"red\"}") ==
        "a.json:2: background: is \"red\"; a colour such as \"#3fa0ff\" is expected");
  CHECK(problem_with("") == "a.json:2: primitives[0]: has no \"type\"; it needs one");
  CHECK(problem_with("\"type\": \"lines\"") ==
        "a.json:2: primitives[0].type: is \"lines\"; did you mean \"line\"? known are line, circle");
  CHECK(problem_with("\"type\": \"line\", \"from\": [0, 0]") == "a.json:2: primitives[0]: has no \"to\"; it needs one");
  CHECK(problem_with("\"type\": \"circle\", \"center\": [0, 0], \"radius\": 2, \"spin_deg\": 2") ==
        "a.json:2: primitives[0].spin_deg: unknown key; known are type, center, radius, width, color, velocity");
  CHECK(problem_with("\"type\": \"line\", \"from\": [0, 0, 1]") ==
        "a.json:2: primitives[0].from: is no pair of numbers; a point is [x, y]");
  CHECK(problem_with("\"type\": \"line\", \"from\": [0, \"1\"]") ==
        "a.json:2: primitives[0].from[1]: is \"1\"; a number from -10000000 to 10000000 is expected");
  const std::string line = "\"type\": \"line\", \"from\": [0, 0],\n\"to\": [1, 1], ";
  CHECK(problem_with(line + "\"cap\": \"flat\"") ==
        "a.json:3: primitives[0].cap: is \"flat\"; known are butt, square, round");
  CHECK(problem_with(line + "\"velocity\": [1]") ==
        "a.json:3: primitives[0].velocity: is no pair of numbers; a velocity is [dx, dy]");
  CHECK(problem_with(line + "\"spin_deg\": true") ==
        "a.json:3: primitives[0].spin_deg: is true; a number from -1000000 to 1000000 is expected");
}

TEST_CASE("numbers that are none, endless, too large or negative widths are refused") {
  const std::string circle = "\"type\": \"circle\", \"center\": [0, 0],\n";
  CHECK(problem_with(circle + "\"radius\": NaN") ==
        "a.json:3: the word NaN is not JSON; texts stand in double quotes, other words are true, false and null");
  CHECK(problem_with(circle + "\"radius\": 1e999") ==
        "a.json:3: the number 1e999 is too large; 1.7e308 is the largest");
  CHECK(problem_with(circle + "\"radius\": 1.5e7") ==
        "a.json:3: primitives[0].radius: is 1.5e7; a number from 0 to 10000000 is expected");
  CHECK(problem_with(circle + "\"radius\": -1") ==
        "a.json:3: primitives[0].radius: is -1; a number from 0 to 10000000 is expected");
  CHECK(problem_with(circle + "\"radius\": 1, \"width\": -0.5") ==
        "a.json:3: primitives[0].width: is -0.5; a number from 0 to 10000000 is expected");
  CHECK(problem_with("\"type\": \"circle\", \"center\": [0, -1e8], \"radius\": 1") ==
        "a.json:2: primitives[0].center[1]: is -1e8; a number from -10000000 to 10000000 is expected");
}

TEST_CASE("the scene reads its file, whose background goes before that of the settings") {
  const TemporaryFolder folder;
  const ScenePlugin& plugin = scene_plugin("primitives");
  const auto settings_of = [&](const std::filesystem::path& file) {
    return changed(plugin.parameters, {{"file", file.string()}, {"background", std::string("#00ff00")}});
  };
  const auto seen_in_the_corner = [&](const std::filesystem::path& file) {
    const Settings settings = settings_of(file);
    const auto frame = plugin.make(settings)->frame(settings, {20, 20});
    const SamplePoint point{1, 1};
    Hit hit;
    Counters counters;
    frame->trace(std::span(&point, 1), std::span(&hit, 1), counters);
    return hit;
  };
  const Hit empty = seen_in_the_corner(folder.file("a.json", "{\"primitives\": []}"));
  CHECK(empty.element == background);
  CHECK(empty.color == Color{0, 1, 0});
  const Hit own = seen_in_the_corner(folder.file("b.json", "{\"primitives\": [], \"background\": \"#0000ff\"}"));
  CHECK(own.color == Color{0, 0, 1});
  const auto broken = folder.file("c.json", "{\n\"primitives\": [3]}");
  CHECK(message_of([&] { plugin.make(settings_of(broken)); }) ==
        broken.string() + ":2: primitives[0]: is 3; an object is expected");
}

}  // namespace moire::test
