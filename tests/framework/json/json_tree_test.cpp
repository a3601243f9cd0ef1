#include "json/json_tree.h"

#include <limits>

#include <catch2/catch_test_macros.hpp>

#include "message_of.h"

namespace moire {
namespace {

std::shared_ptr<const Source> source() { return std::make_shared<Source>(Source{"a.json", "/"}); }

JsonNode parse(std::string_view text) {
  Problems problems;
  auto tree = parse_json(text, source(), "", problems);
  problems.throw_if_any();
  return *std::move(tree);
}

std::string problems_of(std::string_view text) {
  return test::message_of([&] { parse(text); });
}

TEST_CASE("every node knows its line, a number at a line's end too") {
  const JsonNode root = parse("{\n\"a\":\n1\n,\"b\": [2,\n\n3\n],\n  \"c\": {\r\n\"d\": \"x\"}}\n");
  CHECK(root.place.line == 1);
  CHECK(root.members[0].place.line == 2);
  CHECK(root.find("a")->place.line == 3);
  CHECK(root.find("b")->place.line == 4);
  CHECK(root.find("b")->items[0].place.line == 4);
  CHECK(root.find("b")->items[1].place.line == 6);
  CHECK(root.find("c")->place.line == 8);
  CHECK(root.find("c")->find("d")->place.line == 9);
  CHECK(root.find("d") == nullptr);
}

TEST_CASE("comments count as lines and say nothing") {
  const JsonNode root = parse("// a\n{ // b\n\"n\": /* c\n */ 4 // d\n}\n// e");
  CHECK(root.find("n")->integer == 4);
  CHECK(root.find("n")->place.line == 4);
}

TEST_CASE("whole numbers and others are told apart, and huge ones stay what they are") {
  const JsonNode root =
      parse("[1, 1.0, -9223372036854775808, 9223372036854775807, 9223372036854775808, 1e300, true, null]");
  CHECK(root.items[0].is(JsonKind::integer));
  CHECK(root.items[1].is(JsonKind::real));
  CHECK(shown(root.items[1]) == "1.0");
  CHECK(root.items[2].integer == std::numeric_limits<std::int64_t>::min());
  CHECK(root.items[3].integer == std::numeric_limits<std::int64_t>::max());
  CHECK(root.items[4].is(JsonKind::real));
  CHECK(shown(root.items[4]) == "9223372036854775808");
  CHECK(shown(root.items[5]) == "1e300");
  CHECK(shown(root.items[6]) == "true");
  CHECK(shown(root.items[7]) == "null");
}

TEST_CASE("a byte order mark is no part of the text") {
  CHECK(parse("\xEF\xBB\xBF{\"n\": 1}").find("n")->integer == 1);
}

TEST_CASE("a repeated key names both of its lines, however deep it stands") {
  CHECK(problems_of("{\"a\": 1,\n\"b\": [{\"c\": 1,\n\"c\": 2}],\n\"a\": 3, \"a\": 4}") ==
        "a.json:3: b[0].c: repeated key (first on line 2); keep one of them\n"
        "a.json:4: a: repeated key (first on line 1); keep one of them");
}

TEST_CASE("nesting is limited, so that no file can exhaust the stack") {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  CHECK(parse(nested(100)).is(JsonKind::list));
  CHECK(problems_of(nested(101)) == "a.json:1: is nested more than 100 levels deep");
  CHECK(problems_of(std::string(100000, '[')) == "a.json:1: is nested more than 100 levels deep");
  std::string objects;
  for (int i = 0; i < 100000; ++i) objects += "{\"a\":\n";
  CHECK(problems_of(objects) == "a.json:101: is nested more than 100 levels deep");
}

TEST_CASE("what was found is shown short and whole") {
  CHECK(shown(parse("[]")) == "a list");
  CHECK(shown(parse("{}")) == "an object");
  CHECK(shown(parse("\"a\\nb\"")) == "\"a\\nb\"");
  CHECK(member_path("a[0]", "b c\n") == "a[0].\"b c\\n\"");
  CHECK(in_quotes(std::string(59, 'a') + "\u00e9tc") == "\"" + std::string(59, 'a') + "...\"");
}

}  // namespace
}  // namespace moire
