#include "paint.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>

#include <moire/error.h>

#include "named_colors.h"
#include "numbers.h"

namespace cartoon {

namespace {

Rgb unpack(std::uint32_t rgb) {
  return {static_cast<std::uint8_t>(rgb >> 16), static_cast<std::uint8_t>(rgb >> 8), static_cast<std::uint8_t>(rgb)};
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + ('a' - 'A'));
  }
  return lower;
}

std::optional<std::uint32_t> hex_digits(std::string_view digits) {
  std::uint32_t value = 0;
  for (const char c : digits) {
    const auto place = std::string_view("0123456789abcdef").find(c);
    if (place == std::string_view::npos) return std::nullopt;
    value = value << 4 | static_cast<std::uint32_t>(place);
  }
  return value;
}

// After the "#". Four and eight digits have an alpha.
std::optional<Paint> parse_digits(std::string_view digits) {
  const std::optional<std::uint32_t> value = hex_digits(digits);
  if (!value) return std::nullopt;
  switch (digits.size()) {
    case 3: {
      const std::uint32_t r = *value >> 8, g = *value >> 4 & 15, b = *value & 15;
      return Paint{Paint::Kind::color, unpack((r << 16 | g << 8 | b) * 17), {}};
    }
    case 6:
      return Paint{Paint::Kind::color, unpack(*value), {}};
    case 4:
    case 8:
      return Paint{Paint::Kind::unmodelled, {}, {}};
    default:
      return std::nullopt;
  }
}

// "rgb(1, 2, 3)", or with a percent sign after each.
std::optional<Rgb> parse_function(std::string_view text) {
  Numbers numbers(text);
  std::uint8_t channels[3];
  bool percent = false;
  for (int k = 0; k < 3; ++k) {
    k == 0 ? numbers.skip_space() : numbers.skip_separator();
    std::optional<double> value = numbers.number();
    if (!value || !std::isfinite(*value)) return std::nullopt;
    const bool has_sign = numbers.peek() == '%';
    if (k > 0 && has_sign != percent) return std::nullopt;
    percent = has_sign;
    if (percent) {
      numbers.advance();
      *value *= 255;
      *value /= 100;
    }
    channels[k] = static_cast<std::uint8_t>(std::lround(std::clamp(*value, 0.0, 255.0)));
  }
  numbers.skip_space();
  if (numbers.rest() != ")") return std::nullopt;
  return Rgb{channels[0], channels[1], channels[2]};
}

std::optional<Paint> parse(std::string_view lower) {
  using enum Paint::Kind;
  if (lower == "none" || lower == "transparent") return Paint{};
  if (lower == "currentcolor") return Paint{current, {}, {}};
  // A colour of a profile stands behind the one for everybody.
  if (const auto profile = lower.find(" icc-color("); profile != lower.npos) {
    lower = trimmed(lower.substr(0, profile));
  }
  if (lower.starts_with("#")) return parse_digits(lower.substr(1));
  if (lower.starts_with("rgb(") && lower.find('/') == lower.npos) {
    const std::optional<Rgb> rgb = parse_function(lower.substr(4));
    return rgb ? std::optional(Paint{color, *rgb, {}}) : std::nullopt;
  }
  for (const std::string_view other : {"url(", "rgb(", "rgba(", "hsl(", "hsla(", "hwb(", "lab(", "lch(", "oklab(",
                                       "oklch(", "color(", "var(", "context-fill", "context-stroke"}) {
    if (lower.starts_with(other)) return Paint{unmodelled, {}, {}};
  }
  const auto found =
      std::ranges::lower_bound(named_colors, lower, {}, [](const NamedColor& named) { return named.name; });
  if (found == std::end(named_colors) || found->name != lower) return std::nullopt;
  return Paint{color, unpack(found->rgb), {}};
}

}  // namespace

Paint parse_paint(std::string_view text) {
  text = trimmed(text);
  std::optional<Paint> paint = parse(lower_case(text));
  if (!paint) {
    throw moire::Error(
        fmt::format("is {}; a colour is a name, \"#rrggbb\", \"#rgb\" or \"rgb(r, g, b)\"", shown_front(text)));
  }
  paint->text = text;
  return *paint;
}

Rgb parse_hex(std::string_view text) {
  const std::optional<std::uint32_t> value =
      text.size() == 7 && text.front() == '#' ? hex_digits(lower_case(text.substr(1))) : std::nullopt;
  if (!value) throw moire::Error(fmt::format("is {}; a colour is \"#rrggbb\"", shown_front(text)));
  return unpack(*value);
}

}  // namespace cartoon
