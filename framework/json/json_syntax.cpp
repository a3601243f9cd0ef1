// Turns the parser's explanations into what a person would say; those it does not know pass through.
#include "json/json_syntax.h"

#include <cctype>

#include <fmt/format.h>

#include "json/json_tree.h"

namespace moire {
namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// The word (or the single character) that the parser stopped in or just behind.
std::string_view word_at_end(const SyntaxError& error) {
  const std::string_view text(error.read.data(), error.read.size() + error.rest.size());
  std::size_t begin = error.read.size() - 1;
  if (begin > 0 && !is_word(text[begin]) && is_word(text[begin - 1])) --begin;
  std::size_t end = begin + 1;
  if (!is_word(text[begin])) {
    const auto goes_on = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; };  // in UTF-8
    while (end < text.size() && goes_on(text[end])) ++end;
    return text.substr(begin, end - begin);
  }
  while (begin > 0 && is_word(text[begin - 1])) --begin;
  while (end < text.size() && is_word(text[end])) ++end;
  return text.substr(begin, end - begin);
}

// "[json.exception.parse_error.101] parse error at line 3, column 4: syntax error while parsing value - unexpected '}';
// expected ..." without all up to the dash.
std::string in_own_words(std::string_view explanation, bool is_in_list) {
  const auto dash = explanation.find(" - ");
  if (dash != std::string_view::npos) explanation.remove_prefix(dash + 3);
  std::string words(explanation.substr(0, explanation.find("; last read")));
  // It asks for the end of the object or list, but another entry would do as well.
  const std::string_view end = is_in_list ? "; expected ']'" : "; expected '}'";
  if (words.ends_with(end)) words.insert(words.size() - 3, "',' or ");
  return words;
}

}  // namespace

std::string syntax_problem(const SyntaxError& error) {
  const auto says = [&](std::string_view part) { return error.explanation.find(part) != std::string_view::npos; };
  const char closing = error.is_in_list ? ']' : '}';
  if (says("number overflow")) return fmt::format("the number {} is too large; 1.7e308 is the largest", error.token);
  if (says("ill-formed UTF-8")) return "a text is not in UTF-8; save the file as UTF-8";
  if (says("missing closing quote") || says("character U+000A") || says("character U+000D"))
    return "a text has no closing quote";
  if (says("; expected end of input")) return "something follows after the end; a file holds one JSON value";
  if (says("unexpected end of input")) {
    if (error.open_since == 0) return "is empty; a JSON object is expected";
    return fmt::format("the file ends too early; a '{}' is missing for the '{}' of line {}", closing,
                       error.is_in_list ? '[' : '{', error.open_since);
  }
  const bool is_trailing_comma =
      (says("parsing value - unexpected ']'") && error.is_in_list) || says("parsing object key - unexpected '}'");
  if (is_trailing_comma) return fmt::format("a comma stands before '{}'; remove the comma", closing);
  if (says("invalid literal")) {
    const std::string_view word = word_at_end(error);
    if (!is_word(word[0])) return fmt::format("{} is not JSON; texts stand in double quotes", in_quotes(word));
    return fmt::format("the word {} is not JSON; texts stand in double quotes, other words are true, false and null",
                       word.substr(0, 60));
  }
  return fmt::format("not JSON: {}", in_own_words(error.explanation, error.is_in_list));
}

}  // namespace moire
