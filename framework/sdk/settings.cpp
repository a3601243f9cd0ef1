// Settings: the values of a parameter table, read by name and type.
#include <charconv>
#include <utility>

#include <fmt/format.h>

#include <moire/color.h>
#include <moire/error.h>
#include <moire/settings.h>

namespace moire {

namespace {

using Values = std::map<std::string, Value, std::less<>>;

Value default_value(const Parameter& parameter) {
  switch (parameter.type) {
    case Type::flag:
      return parameter.number != 0;
    case Type::integer:
      return static_cast<std::int64_t>(parameter.number);
    case Type::real:
      return parameter.number;
    case Type::text:
    case Type::choice:
    case Type::file:
    case Type::color:
      return std::string(parameter.text);
  }
  throw Error(fmt::format("parameter {}: has no known type ({})", parameter.name, static_cast<int>(parameter.type)));
}

std::string names(const Values& values) {
  std::string list;
  for (const auto& [name, value] : values) list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", name);
  return list.empty() ? "no parameters" : list;
}

// The value called `name`, of constant or changeable `values`.
template <class Map>
auto& entry(Map& values, std::string_view name) {
  const auto found = values.find(name);
  if (found == values.end()) {
    throw Error(fmt::format("settings: the plugin asks for \"{}\", which is not in its parameter table; that has {}",
                            name, names(values)));
  }
  return found->second;
}

template <class T>
const T& get(const Values& values, std::string_view name, std::string_view asked_as) {
  constexpr std::string_view types[] = {"a flag", "an integer", "a real", "text"};  // in the order of Value
  const Value& value = entry(values, name);
  if (const T* found = std::get_if<T>(&value)) return *found;
  throw Error(fmt::format("settings: the plugin asks for \"{}\" as {}; its parameter table declares {}", name, asked_as,
                          types[value.index()]));
}

}  // namespace

Settings::Settings(std::span<const Parameter> table) {
  for (const Parameter& parameter : table) values_.emplace(parameter.name, default_value(parameter));
}

bool Settings::flag(std::string_view name) const { return get<bool>(values_, name, "a flag"); }
std::int64_t Settings::integer(std::string_view name) const { return get<std::int64_t>(values_, name, "an integer"); }
double Settings::real(std::string_view name) const { return get<double>(values_, name, "a real"); }
const std::string& Settings::text(std::string_view name) const { return get<std::string>(values_, name, "text"); }

void Settings::set(std::string_view name, Value value) { entry(values_, name) = std::move(value); }

Color parse_color(std::string_view text) {
  std::uint32_t rgb = 0;
  const bool has_form = text.size() == 7 && text.front() == '#';
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + (has_form ? 1 : 0), end, rgb, 16);
  if (!has_form || error != std::errc() || stop != end) {
    throw Error(
        fmt::format("color is \"{}\"; it must be # and two hexadecimal digits each for red, green and blue, "
                    "such as \"#80b0ff\"",
                    text));
  }
  const auto light = [rgb](int shift) { return static_cast<float>(srgb_to_linear(((rgb >> shift) & 0xff) / 255.0)); };
  return {light(16), light(8), light(0)};
}

}  // namespace moire
