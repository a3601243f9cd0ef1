// Checks type and range of a value and says what would be right.
#include "config/value_reader.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>

#include "config/experiment_format.h"
#include "json/nearest_name.h"

namespace moire {
namespace {

// "1 to 256 points". Requires: one end at least is a number.
std::string range(const Parameter& p) {
  const std::string unit = p.unit.empty() ? "" : fmt::format(" {}", p.unit);
  // 2^53 is to be read as such, and not as 9.007e15.
  const auto number = [&](double value) {
    return p.type == Type::integer ? fmt::format("{:.0f}", value) : fmt::format("{}", value);
  };
  if (std::isinf(p.largest)) return fmt::format("{}{} or more", number(p.smallest), unit);
  if (std::isinf(p.smallest)) return fmt::format("{}{} or less", number(p.largest), unit);
  return fmt::format("{} to {}{}", number(p.smallest), number(p.largest), unit);
}

// What the parameter takes, to someone who gave a value of another type.
std::string wanted(const Parameter& p) {
  switch (p.type) {
    case Type::flag:
      return "true or false";
    case Type::integer:
      return fmt::format("a whole number, {}", range(p));
    case Type::real:
      if (!std::isinf(p.smallest) || !std::isinf(p.largest)) return fmt::format("a number, {}", range(p));
      return p.unit.empty() ? "a number" : fmt::format("a number in {}", p.unit);
    case Type::text:
      return "a text";
    case Type::choice:
      return listed(format::words(p.choices));
    case Type::file:
      return "the path of a file, or \"\" for none";
    case Type::color:
      return "a colour such as \"#3fa0ff\"";
  }
  return {};
}

bool is_color(std::string_view text) {
  const auto is_digit = [](unsigned char c) { return std::isxdigit(c) != 0; };
  return text.size() == 7 && text[0] == '#' && std::all_of(text.begin() + 1, text.end(), is_digit);
}

class ValueReader {
 public:
  ValueReader(const JsonNode& node, const std::string& path, const Parameter& parameter, std::string_view owner,
              const Reading& reading)
      : node_(node), path_(path), parameter_(parameter), owner_(owner), reading_(reading) {}

  std::optional<Cell> read() const {
    switch (parameter_.type) {
      case Type::flag:
        return node_.is(JsonKind::flag) ? cell(node_.flag) : refuse(wanted(parameter_));
      case Type::integer:
        return node_.is(JsonKind::integer) ? in_range(node_.integer) : refuse(wanted(parameter_));
      case Type::real:
        return node_.is_number() ? in_range(node_.real) : refuse(wanted(parameter_));
      default:
        return node_.is(JsonKind::text) ? read_text() : refuse(wanted(parameter_));
    }
  }

 private:
  template <class T>
  static Cell cell(const T& value) {
    return {value, value};
  }

  template <class T>
  std::optional<Cell> in_range(T value) const {
    const auto exact = static_cast<long double>(value);  // holds every integer of 64 bits
    const bool is_inside = exact >= parameter_.smallest && exact <= parameter_.largest;
    return is_inside ? cell(value) : refuse(range(parameter_));
  }

  std::optional<Cell> read_text() const {
    const std::string& text = node_.text;
    if (parameter_.type == Type::choice) return read_choice();
    if (parameter_.type == Type::file && !text.empty()) return read_file();
    if (parameter_.type == Type::color && !is_color(text)) return refuse(wanted(parameter_));
    return cell(text);
  }

  std::optional<Cell> read_choice() const {
    const auto choices = format::words(parameter_.choices);
    if (std::find(choices.begin(), choices.end(), node_.text) != choices.end()) return cell(node_.text);
    return refuse(wanted(parameter_), did_you_mean(node_.text, choices));
  }

  std::optional<Cell> read_file() const {
    const FoundFile found = reading_.files.find(node_.text, node_.place.source->folder);
    if (found.file.empty()) {
      reading_.problems.add(node_.place, path_, fmt::format("is {}, {}", shown(node_), found.problem));
      return std::nullopt;
    }
    const bool is_data = DataFiles::is_data(node_.text);
    return Cell{found.file.string(), is_data ? node_.text : found.file.string()};
  }

  std::optional<Cell> refuse(std::string_view wanted_instead, std::string_view hint = ";") const {
    reading_.problems.add(node_.place, path_,
                          fmt::format("is {}{} \"{}\" takes {}", shown(node_), hint, owner_, wanted_instead));
    return std::nullopt;
  }

  const JsonNode& node_;
  const std::string& path_;
  const Parameter& parameter_;
  std::string_view owner_;
  const Reading& reading_;
};

}  // namespace

std::optional<Cell> read_value(const JsonNode& node, const std::string& path, const Parameter& parameter,
                               std::string_view owner, const Reading& reading) {
  return ValueReader(node, path, parameter, owner, reading).read();
}

Cell default_cell(const Parameter& parameter) {
  const Settings defaults(std::span(&parameter, 1));
  const Value& value = defaults.values().begin()->second;
  return {value, std::visit([](const auto& v) { return nlohmann::ordered_json(v); }, value)};
}

}  // namespace moire
