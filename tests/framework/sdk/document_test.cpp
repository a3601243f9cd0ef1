#include <moire/document.h>

#include <limits>

#include <moire/settings.h>
#include <catch2/catch_test_macros.hpp>

#include "message_of.h"
#include "temporary_folder.h"

namespace moire {
namespace {

using test::message_of;

constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr std::string_view example = R"({  // two lines and a name
  "lines": [
    {"from": [1, -2.5], "cap": "round"},
    {"from": [3, 4e2, 5], "cap": "rounded", "color": "#ff0080",
     "hidden": true}
  ],
  "name": "fan",
  "two words": 1
})";

// The message that reading something of the example gives.
template <class Read>
std::string refusal(Read read) {
  return message_of([&] {
    const Document document(example, "scene.json");
    read(document.root());
  });
}

TEST_CASE("a document's values are read as what they are") {
  const Document document(example, "scene.json");
  const DocumentValue root = document.root(), lines = root["lines"], second = lines[1];
  CHECK(lines.size() == 2);
  CHECK(lines[0]["from"].size() == 2);
  CHECK(lines[0]["from"][0].number(1, 1) == 1);
  CHECK(lines[0]["from"][1].number(-infinity, infinity) == -2.5);
  CHECK(second["from"][1].number(0, 1000) == 400);
  CHECK(lines[0]["cap"].choice({"butt", "square", "round"}) == 2);
  CHECK(second["hidden"].flag());
  CHECK(second["color"].color() == parse_color("#ff0080"));
  CHECK(root["name"].text() == "fan");
  CHECK(second.has("color"));
  CHECK_FALSE(lines[0].has("color"));
  CHECK_NOTHROW(root.allow_only({"lines", "name", "two words", "background"}));
}

TEST_CASE("a document keeps what it needs of its text") {
  std::string text(example);
  const Document document(text, "scene.json");
  text.assign(text.size(), ' ');
  CHECK(document.root()["name"].text() == "fan");
}

TEST_CASE("a wrong value of a document is refused with its line, its path, what was found and what would be right") {
  using Value = const DocumentValue&;
  // Objects
  CHECK(refusal([](Value v) { v["circles"]; }) == "scene.json:1: has no \"circles\"; it needs one");
  CHECK(refusal([](Value v) { v["lines"][0]["to"]; }) == "scene.json:3: lines[0]: has no \"to\"; it needs one");
  CHECK(refusal([](Value v) { v["lines"]["to"]; }) == "scene.json:2: lines: is a list; an object is expected");
  CHECK(refusal([](Value v) { v["name"].has("to"); }) == "scene.json:7: name: is \"fan\"; an object is expected");
  CHECK(refusal([](Value v) { v["lines"].allow_only({}); }) == "scene.json:2: lines: is a list; an object is expected");
  CHECK(refusal([](Value v) {
          v["lines"][1].allow_only({"from", "cap", "colour"});
        }) == "scene.json:4: lines[1].color: unknown key; did you mean \"colour\"? known are from, cap, colour");
  CHECK(refusal([](Value v) {
          v["lines"][1].allow_only({"from", "cap", "color"});
        }) == "scene.json:5: lines[1].hidden: unknown key; known are from, cap, color");
  CHECK(refusal([](Value v) {
          v.allow_only({"lines", "name"});
        }) == "scene.json:8: \"two words\": unknown key; known are lines, name");

  // Lists
  CHECK(refusal([](Value v) { v.size(); }) == "scene.json:1: is an object; a list is expected");
  CHECK(refusal([](Value v) { v["name"][0]; }) == "scene.json:7: name: is \"fan\"; a list is expected");
  CHECK(refusal([](Value v) { v["lines"][0]["from"][2]; }) ==
        "scene.json:3: lines[0].from: has 2 items; it needs 3 or more");

  // Numbers
  CHECK(refusal([](Value v) { v["name"].number(0, 1); }) ==
        "scene.json:7: name: is \"fan\"; a number from 0 to 1 is expected");
  CHECK(refusal([](Value v) { v["lines"][0]["from"][1].number(0, infinity); }) ==
        "scene.json:3: lines[0].from[1]: is -2.5; a number of 0 or more is expected");
  CHECK(refusal([](Value v) { v["lines"][1]["from"][1].number(-infinity, 10); }) ==
        "scene.json:4: lines[1].from[1]: is 4e2; a number of 10 or less is expected");
  CHECK(refusal([](Value v) { v["lines"][1]["hidden"].number(-infinity, infinity); }) ==
        "scene.json:5: lines[1].hidden: is true; a number is expected");

  // Flags, texts, choices, colours
  CHECK(refusal([](Value v) { v["two words"].flag(); }) ==
        "scene.json:8: \"two words\": is 1; true or false is expected");
  CHECK(refusal([](Value v) { v["two words"].text(); }) == "scene.json:8: \"two words\": is 1; a text is expected");
  CHECK(refusal([](Value v) {
          v["lines"][1]["cap"].choice({"butt", "square", "round"});
        }) == "scene.json:4: lines[1].cap: is \"rounded\"; did you mean \"round\"? known are butt, square, round");
  CHECK(refusal([](Value v) {
          v["two words"].choice({"butt", "1"});
        }) == "scene.json:8: \"two words\": is 1; known are butt, 1");
  CHECK(refusal([](Value v) { v["name"].color(); }) ==
        "scene.json:7: name: is \"fan\"; a colour such as \"#3fa0ff\" is expected");
  CHECK(refusal([](Value v) { v["lines"][1]["from"].color(); }) ==
        "scene.json:4: lines[1].from: is a list; a colour such as \"#3fa0ff\" is expected");

  // In the reader's own words
  CHECK(refusal([](Value v) { v["lines"][1]["from"].refuse("has 3 numbers; a point is [x, y]"); }) ==
        "scene.json:4: lines[1].from: has 3 numbers; a point is [x, y]");
  CHECK(refusal([](Value v) { v.refuse("is empty; a line at least is needed"); }) ==
        "scene.json:1: is empty; a line at least is needed");
}

TEST_CASE("a document that is not JSON is refused as an experiment would be") {
  const auto problem = [](std::string_view text) { return message_of([&] { Document(text, "scene.json"); }); };
  CHECK(problem("") == "scene.json:1: is empty; a JSON object is expected");
  CHECK(problem("{\n\"a\": 1,\n}") == "scene.json:3: a comma stands before '}'; remove the comma");
  CHECK(problem("{\"a\": 1,\n\"a\": 2,\n\"b\": {\"c\": 1, \"c\": 1}}") ==
        "scene.json:2: a: repeated key (first on line 1); keep one of them\n"
        "scene.json:3: b.c: repeated key (first on line 3); keep one of them");
  CHECK(problem("[1e999]") == "scene.json:1: the number 1e999 is too large; 1.7e308 is the largest");
}

TEST_CASE("a document is read from a file, which messages name") {
  const test::TemporaryFolder folder;
  const auto file = folder.file("scene.json", "{\n\"n\": 2}");
  CHECK(Document(file).root()["n"].number(0, 9) == 2);
  CHECK(message_of([&] { Document(file).root()["n"].flag(); }) ==
        file.string() + ":2: n: is 2; true or false is expected");
  const auto missing = folder.path() / "none.json";
  CHECK(message_of([&] { Document{missing}; }) ==
        missing.string() + ": cannot be read (No such file or directory); a readable file is needed");
}

}  // namespace
}  // namespace moire
