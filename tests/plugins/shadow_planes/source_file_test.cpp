// Worlds from files: what they say, and what is refused, message by message.
#include <catch2/catch_test_macros.hpp>
#include <string>

#include <moire/error.h>

#include "plugins/shadow_planes/worlds.h"
#include "world/source_file.h"

namespace moire::test {
namespace {

using namespace shadow_planes;

Source source_of(const std::string& text) { return read_source(Document(text, "world.json")); }

std::string message_of(const std::string& text) {
  try {
    source_of(text);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

std::string message_of_face(const std::string& face) {
  return message_of(R"({"light": {"at": [0, 0, 4]}, "faces": [)" + face + "]}");
}

std::string message_of_light(const std::string& light) {
  return message_of(R"({"light": )" + light + R"(, "faces": []})");
}

}  // namespace

TEST_CASE("a world says what its faces and its light are") {
  const Source source = source_of(R"({
    "light": {"points": [[0, 0, 4], [0, 1, 4], [1, 1, 4], [1, 0, 4]], "at": [1, 2, 3], "towards": [0, 0, 2],
              "color": "#ff0000"},
    "faces": [
      {"points": [[0, 0, 0], [4, 0, 0], [4, 4, 0], [2, 1, 0], [0, 4, 0]], "reflectance": "#ffffff"},  // concave
      {"points": [[0, 0, 1], [1, 0, 1], [1, 1, 1]], "casts": false, "receives": false}]})");
  CHECK(source.light.corners.size() == 4);
  CHECK((source.light.at == Vector{1, 2, 3} && source.light.towards == Vector{0, 0, 2}));
  CHECK(source.light.color == Color{1, 0, 0});
  REQUIRE(source.faces.size() == 2);
  CHECK(source.faces[0].parts.size() > 1);
  CHECK(source.faces[0].reflectance == Color{1, 1, 1});
  CHECK((source.faces[0].casts && source.faces[0].receives));
  CHECK((!source.faces[1].casts && !source.faces[1].receives));
  CHECK(source.faces[1].reflectance == Face().reflectance);
}

TEST_CASE("wrong worlds are refused with the place, what was found and what would be right") {
  CHECK(message_of(R"({"light": {"at": [0, 0, 4]}})") == "world.json:1: has no \"faces\"; it needs one");
  CHECK(message_of_face(R"({"points": [[0, 0, 0], [1, 0, 0]]})") ==
        "world.json:1: faces[0].points: is no polygon (2 corners); 3 or more make one");
  CHECK(message_of_face(R"({"points": [[0, 0, 0], [1, 0, 0], [0, 1]]})") ==
        "world.json:1: faces[0].points[2]: has 2 numbers; a place has x, y and z");
  CHECK(message_of_face(R"({"points": [[0, 0, 0], [1, 0, 0], [0, 1, 1e300]]})") ==
        "world.json:1: faces[0].points[2][2]: is 1e300; a number from -1000000 to 1000000 is expected");
  CHECK(message_of_face(R"({"points": [[0, 0, 0], [1, 0, 0], [0, 1, NaN]]})") ==
        "world.json:1: the word NaN is not JSON; texts stand in double quotes, other words are true, false and null");
  CHECK(message_of_face(R"({"points": [[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 0]]})") ==
        "world.json:1: faces[0].points: is not flat (a corner is 0.204 off its plane); 1.73e-09 at most is");
  CHECK(message_of_face(R"({"points": [[0, 0, 0], [2, 0, 0], [0, 1, 0], [1.5, 1.8, 0]]})") ==
        "world.json:1: faces[0].points: crosses itself (sides from corners 1 and 3); a simple polygon does not");
  CHECK(message_of_face(R"({"points": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "cast": true})") ==
        "world.json:1: faces[0].cast: unknown key; did you mean \"casts\"? known are points, reflectance, casts, "
        "receives, shown");
  CHECK(message_of_face(R"({"points": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "reflectance": 0.5})") ==
        "world.json:1: faces[0].reflectance: is 0.5; a colour such as \"#3fa0ff\" is expected");
  CHECK(message_of_light(R"({"towards": [0, 0, 0]})") ==
        "world.json:1: light.towards: is [0, 0, 0]; a direction has a length");
  CHECK(message_of_light(R"([0, 0, 4])") == "world.json:1: light: is a list; an object is expected");
}

TEST_CASE("a light has what its kind needs, from its file or from what the file gives instead") {
  LightShape shape;
  CHECK(problem_of(shape, LightKind::area) == "has no \"points\"; light.kind \"area\" needs the polygon that shines");
  CHECK(problem_of(shape, LightKind::point) ==
        "has no \"at\" and no polygon whose middle it could be; light.kind \"point\" needs one of them, "
        "\"directional\" them or \"towards\"");
  shape.at = Vector{};
  CHECK(problem_of(shape, LightKind::directional) ==
        "has no \"towards\" and lies at the origin; light.kind \"directional\" needs a direction");
  shape.at.reset();
  shape.corners = {{0, 0, 4}, {0, 2, 4}, {2, 2, 4}};
  for (const LightKind kind : {LightKind::area, LightKind::point, LightKind::directional})
    CHECK(problem_of(shape, kind).empty());
  const Light point = light_of(shape, shadow_settings({{"light.kind", std::string("point")}, {"light.x", 1.0}}));
  CHECK(length(point.place - Vector{2.0 / 3 + 1, 4.0 / 3, 4}) <= 1e-14);
  shape.corners = {{0, 0, 4}, {1, 0, 4}, {2, 0, 4}};
  CHECK(problem_of(shape, LightKind::area) ==
        "has points without area; light.kind \"area\" needs a polygon that has one");
}

TEST_CASE("a light's power does not depend on its size") {
  const LightShape shape = kind_of_name("tilted").light;
  const auto power = [&](double size) {
    const Light light = light_of(shape, shadow_settings({{"light.size", size}}));
    return static_cast<double>(light.color.r) * LightPoints(light).area();
  };
  CHECK(std::abs(power(1) / power(0.01) - 1) <= 1e-6);
  CHECK(std::abs(power(1) / power(3) - 1) <= 1e-6);
}

}  // namespace moire::test
