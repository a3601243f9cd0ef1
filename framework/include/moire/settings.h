// Parameters, declared once as a table, and the settings that a plugin is made from.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace moire {

// `file` is a path, checked to exist before the first run; `color` is "#rrggbb" in sRGB code values.
enum class Type { flag, integer, real, text, choice, file, color };

using Value = std::variant<bool, std::int64_t, double, std::string>;

// One row of a plugin's parameter table. Made by the functions below; defaults, range checks, help, documentation and
// the experiment schema all come from it. A name with a dot ("view.pitch_deg") is a member of an object in JSON.
struct Parameter {
  std::string_view name;
  Type type = Type::real;
  std::string_view meaning;          // a phrase: what it does
  std::string_view unit = "";        // of numbers; empty for counts and ratios
  double number = 0;                 // default of flags and numbers
  std::string_view text = "";        // default of the other types
  double smallest = 0, largest = 0;  // numbers, both ends allowed
  std::string_view choices = "";     // of a choice: "column grid"
  bool is_per_frame = false;         // may be animated, and changed without making the scene again
  std::string_view exact = "";       // the setting under which the scene is exact, as text; empty: any is

  constexpr Parameter per_frame() const {
    Parameter p = *this;
    p.is_per_frame = true;
    return p;
  }
  // References are rendered with this setting whatever the experiment asks for.
  constexpr Parameter exact_when(std::string_view setting) const {
    Parameter p = *this;
    p.exact = setting;
    return p;
  }
};

namespace parameter {

constexpr Parameter flag(std::string_view name, bool value, std::string_view meaning) {
  return {.name = name, .type = Type::flag, .meaning = meaning, .number = value ? 1.0 : 0.0};
}
constexpr Parameter integer(std::string_view name, std::int64_t value, std::int64_t smallest, std::int64_t largest,
                            std::string_view unit, std::string_view meaning) {
  return {.name = name,
          .type = Type::integer,
          .meaning = meaning,
          .unit = unit,
          .number = static_cast<double>(value),
          .smallest = static_cast<double>(smallest),
          .largest = static_cast<double>(largest)};
}
constexpr Parameter real(std::string_view name, double value, double smallest, double largest, std::string_view unit,
                         std::string_view meaning) {
  return {.name = name,
          .type = Type::real,
          .meaning = meaning,
          .unit = unit,
          .number = value,
          .smallest = smallest,
          .largest = largest};
}
constexpr Parameter choice(std::string_view name, std::string_view value, std::string_view choices,
                           std::string_view meaning) {
  return {.name = name, .type = Type::choice, .meaning = meaning, .text = value, .choices = choices};
}
constexpr Parameter text(std::string_view name, std::string_view value, std::string_view meaning) {
  return {.name = name, .type = Type::text, .meaning = meaning, .text = value};
}
constexpr Parameter file(std::string_view name, std::string_view meaning) {
  return {.name = name, .type = Type::file, .meaning = meaning};
}
constexpr Parameter color(std::string_view name, std::string_view value, std::string_view meaning) {
  return {.name = name, .type = Type::color, .meaning = meaning, .text = value};
}

}  // namespace parameter

// A complete assignment of a table's parameters: every one has a value of its type, in range.
class Settings {
 public:
  Settings() = default;
  // All defaults.
  explicit Settings(std::span<const Parameter> table);

  // Error (a mistake of the plugin's author): no such parameter, or of another type.
  bool flag(std::string_view name) const;
  std::int64_t integer(std::string_view name) const;
  double real(std::string_view name) const;
  const std::string& text(std::string_view name) const;  // of text, choice, file and color

  // Requires: the parameter is in the table and the value has its type and range.
  void set(std::string_view name, Value value);

  const std::map<std::string, Value, std::less<>>& values() const { return values_; }
  friend bool operator==(const Settings&, const Settings&) = default;

 private:
  std::map<std::string, Value, std::less<>> values_;
};

// "#rrggbb" (sRGB) to linear light. Error: not of that form.
struct Color;
Color parse_color(std::string_view text);

}  // namespace moire
