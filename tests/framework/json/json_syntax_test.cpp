#include <catch2/catch_test_macros.hpp>

#include "json/json_tree.h"
#include "message_of.h"

namespace moire {
namespace {

std::string problem_of(std::string_view text) {
  return test::message_of([&] {
    Problems problems;
    parse_json(text, std::make_shared<Source>(Source{"a.json", "/"}), "", problems);
    problems.throw_if_any();
  });
}

TEST_CASE("a syntax error says on which line it is and what to do") {
  struct Case {
    std::string_view caption, text, message;
  };
  constexpr Case cases[] = {
      {"nothing", "", "a.json:1: is empty; a JSON object is expected"},
      {"blank lines", "\n\n", "a.json:2: is empty; a JSON object is expected"},
      {"a comment only", "// nothing yet\n", "a.json:1: is empty; a JSON object is expected"},
      {"comma before }", "{\n\"a\": 1,\n}", "a.json:3: a comma stands before '}'; remove the comma"},
      {"comma before ]", "{\"a\": [1,\n2,\n]}", "a.json:3: a comma stands before ']'; remove the comma"},
      {"missing comma", "{\"a\": 1\n\"b\": 2}", "a.json:2: not JSON: unexpected string literal; expected ',' or '}'"},
      {"missing comma in a list", "[1 2]", "a.json:1: not JSON: unexpected number literal; expected ',' or ']'"},
      {"missing colon", "{\"a\" 1}", "a.json:1: not JSON: unexpected number literal; expected ':'"},
      {"wrong bracket", "{\"a\": [1}", "a.json:1: not JSON: unexpected '}'; expected ',' or ']'"},
      {"value missing", "{\"a\": }", "a.json:1: not JSON: unexpected '}'; expected '[', '{', or a literal"},
      {"object not closed", "{\n\"a\": {\n\"b\": 1\n",
       "a.json:3: the file ends too early; a '}' is missing for the '{' of line 2"},
      {"list not closed", "{\n\"a\": [\n1,",
       "a.json:3: the file ends too early; a ']' is missing for the '[' of line 2"},
      {"more behind the end", "{}\n{}", "a.json:2: something follows after the end; a file holds one JSON value"},
      {"text not closed", "{\"a\": \"b\n}", "a.json:1: a text has no closing quote"},
      {"text not closed at the end", "{\"a\": \"b", "a.json:1: a text has no closing quote"},
      {"single quotes", "{'a': 1}", "a.json:1: \"'\" is not JSON; texts stand in double quotes"},
      {"a word processor's quotes", "{\n\u201ca\u201d: 1}",
       "a.json:2: \"\u201c\" is not JSON; texts stand in double quotes"},
      {"no opening quote", "{a\": 1}",
       "a.json:1: the word a is not JSON; texts stand in double quotes, other words are true, false and null"},
      {"a bare word", "{\"a\":\n  True}",
       "a.json:2: the word True is not JSON; texts stand in double quotes, other words are true, false and null"},
      {"half a word", "{\"a\": tru}",
       "a.json:1: the word tru is not JSON; texts stand in double quotes, other words are true, false and null"},
      {"not a number", "{\"a\": NaN}",
       "a.json:1: the word NaN is not JSON; texts stand in double quotes, other words are true, false and null"},
      {"too large", "{\"a\":\n 1e999}", "a.json:2: the number 1e999 is too large; 1.7e308 is the largest"},
      {"half a number", "[-]", "a.json:1: not JSON: invalid number; expected digit after '-'"},
      {"not UTF-8", "{\"a\":\n \"\xff\"}", "a.json:2: a text is not in UTF-8; save the file as UTF-8"},
      {"half a byte order mark", "\xEF\xBB{}", "a.json:1: not JSON: invalid BOM; must be 0xEF 0xBB 0xBF if given"},
      {"unknown escape", "[\"\\q\"]", "a.json:1: not JSON: invalid string: forbidden character after backslash"},
  };
  for (const Case& c : cases) {
    INFO(c.caption);
    CHECK(problem_of(c.text) == c.message);
  }
}

}  // namespace
}  // namespace moire
