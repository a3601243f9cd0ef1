// HTML and SVG as values. Text becomes markup by being escaped, so what comes from data cannot become an element.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace moire::report {

class Markup {
 public:
  Markup() = default;
  // Escaped. Implicit, so that text may stand wherever markup is wanted.
  Markup(std::string_view text);
  Markup(const std::string& text) : Markup(std::string_view(text)) {}
  Markup(const char* text) : Markup(std::string_view(text)) {}

  // As it is. Requires: it comes from the program, not from data.
  static Markup verbatim(std::string text);

  Markup& operator+=(const Markup& other);
  friend Markup operator+(Markup a, const Markup& b) { return a += b; }

  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

struct Attribute {
  std::string_view name;
  std::string value;  // escaped when written; an empty one is written too
};
using Attributes = std::initializer_list<Attribute>;

// <name attributes>content</name>
Markup tag(std::string_view name, Attributes attributes, const Markup& content);
Markup tag(std::string_view name, const Markup& content);

// An element that never has content nor an end: <meta>, <input>, <br>.
Markup void_tag(std::string_view name, Attributes attributes);

// A coordinate with one decimal.
std::string coordinate(double value);

}  // namespace moire::report
