#include "style.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <moire/error.h>

#include "numbers.h"

namespace cartoon {

namespace {

using moire::Error;

[[noreturn]] void refuse(std::string_view value, std::string_view right) {
  throw Error(fmt::format("is {}; {}", shown_front(value), right));
}

double opacity(std::string_view value) {
  Numbers numbers(value);
  std::optional<double> number = numbers.number();
  if (number && numbers.rest() == "%") {
    *number /= 100;
    numbers.advance();
  }
  if (!number || !numbers.at_end() || std::isnan(*number)) refuse(value, "an opacity is a number, 0 to 1");
  return std::clamp(*number, 0.0, 1.0);
}

// Of any unit, since only 0 is told from the rest.
bool is_width(std::string_view value) {
  const std::optional<double> number = Numbers(value).number();
  if (!number) refuse(value, "a width is a number");
  return *number != 0;
}

struct Property {
  std::string_view name;
  void (*apply)(std::string_view value, Style& style, OwnStyle& own);
};

constexpr Property properties[] = {
    {"fill", [](std::string_view value, Style& style, OwnStyle&) { style.fill = parse_paint(value); }},
    {"fill-opacity", [](std::string_view value, Style& style, OwnStyle&) { style.fill_opacity = opacity(value); }},
    {"fill-rule",
     [](std::string_view value, Style& style, OwnStyle&) {
       if (value != "nonzero" && value != "evenodd") refuse(value, "known are nonzero and evenodd");
       style.rule = value == "evenodd" ? moire::FillRule::even_odd : moire::FillRule::nonzero;
     }},
    {"stroke", [](std::string_view value, Style& style, OwnStyle&) { style.stroke = parse_paint(value); }},
    {"stroke-width", [](std::string_view value, Style& style, OwnStyle&) { style.stroke_has_width = is_width(value); }},
    {"stroke-opacity", [](std::string_view value, Style& style, OwnStyle&) { style.stroke_opacity = opacity(value); }},
    {"visibility", [](std::string_view value, Style& style, OwnStyle&) { style.visible = value == "visible"; }},
    {"color",
     [](std::string_view value, Style& style, OwnStyle& own) {
       const Paint paint = parse_paint(value);
       if (paint.kind == Paint::Kind::color) style.color = paint.rgb;
       if (paint.kind == Paint::Kind::unmodelled) own.unmodelled.push_back(fmt::format("color {}", value));
     }},
    {"display",
     [](std::string_view value, Style&, OwnStyle& own) {
       if (value == "none") own.shown = false;
     }},
    {"opacity",
     [](std::string_view value, Style&, OwnStyle& own) {
       const double number = opacity(value);
       if (number == 0) own.shown = false;
       if (number > 0 && number < 1) own.unmodelled.push_back(fmt::format("opacity {}", value));
     }},
};

// What changes a picture unless it has the value that leaves everything as it is.
struct Effect {
  std::string_view name, without;
};
constexpr Effect effects[] = {
    {"clip-path", "none"},        {"mask", "none"},         {"filter", "none"},
    {"mix-blend-mode", "normal"}, {"marker", "none"},       {"marker-end", "none"},
    {"marker-mid", "none"},       {"marker-start", "none"}, {"transform-origin", ""},
};
// Attributes that CSS may set as well.
constexpr std::string_view geometry[] = {"transform", "d", "x", "y", "cx", "cy", "r", "rx", "ry"};

void apply(std::string_view name, std::string_view value, Style& style, OwnStyle& own) {
  if (value == "inherit") return;
  const auto property = std::ranges::find(properties, name, &Property::name);
  const auto effect = std::ranges::find(effects, name, &Effect::name);
  try {
    if (property != std::end(properties)) property->apply(value, style, own);
  } catch (const Error& error) {
    throw Error(fmt::format("{} {}", name, error.what()));
  }
  if (effect != std::end(effects) && value != effect->without) {
    own.unmodelled.push_back(fmt::format("{} {}", name, value));
  }
}

void apply_declarations(std::string_view text, Style& style, OwnStyle& own) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(';'), text.size());
    const std::string_view declaration = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (declaration.empty()) continue;
    const std::size_t colon = declaration.find(':');
    if (colon == declaration.npos) {
      throw Error(fmt::format("style has {}; it takes \"property: value\"", shown_front(declaration)));
    }
    const std::string_view name = trimmed(declaration.substr(0, colon));
    std::string_view value = trimmed(declaration.substr(colon + 1));
    if (const auto mark = value.rfind('!'); mark != value.npos && trimmed(value.substr(mark + 1)) == "important") {
      value = trimmed(value.substr(0, mark));
    }
    if (std::ranges::find(geometry, name) != std::end(geometry)) {
      own.unmodelled.push_back(fmt::format("{} in style", name));
    }
    apply(name, value, style, own);
  }
}

// Entities of a document type stay as they are written.
bool has_entity(std::string_view text) {
  const std::size_t begin = text.find('&');
  return begin != text.npos && text.find(';', begin) != text.npos;
}

}  // namespace

OwnStyle read_style(const pugi::xml_node& element, Style& style) {
  OwnStyle own;
  std::string_view declarations;
  for (const pugi::xml_attribute& attribute : element.attributes()) {
    const std::string_view name = attribute.name(), value = trimmed(attribute.value());
    if (name == "style") {
      declarations = value;
    } else if (name.find(':') == name.npos) {
      apply(name, value, style, own);
    }
  }
  if (has_entity(declarations)) {
    own.unmodelled.push_back(fmt::format("entity {} in style", declarations));
  } else {
    apply_declarations(declarations, style, own);
  }
  return own;
}

}  // namespace cartoon
