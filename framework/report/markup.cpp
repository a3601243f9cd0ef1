// HTML and SVG as values.
#include "report/markup.h"

#include <fmt/format.h>

namespace moire::report {
namespace {

std::string escaped(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string opening(std::string_view name, Attributes attributes) {
  std::string out = fmt::format("<{}", name);
  for (const Attribute& attribute : attributes)
    out += fmt::format(" {}=\"{}\"", attribute.name, escaped(attribute.value));
  return out + '>';
}

}  // namespace

Markup::Markup(std::string_view text) : text_(escaped(text)) {}

Markup Markup::verbatim(std::string text) {
  Markup markup;
  markup.text_ = std::move(text);
  return markup;
}

Markup& Markup::operator+=(const Markup& other) {
  text_ += other.text_;
  return *this;
}

Markup tag(std::string_view name, Attributes attributes, const Markup& content) {
  return Markup::verbatim(opening(name, attributes) + content.text() + fmt::format("</{}>", name));
}

Markup tag(std::string_view name, const Markup& content) { return tag(name, {}, content); }

Markup void_tag(std::string_view name, Attributes attributes) { return Markup::verbatim(opening(name, attributes)); }

std::string coordinate(double value) { return fmt::format("{:.1f}", value); }

}  // namespace moire::report
