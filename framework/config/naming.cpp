// Makes names and checks that they are fit to be folders.
#include "config/naming.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include <fmt/format.h>

namespace moire {
namespace {

std::string short_form(const Parameter& parameter, const Value& value) {
  if (parameter.type == Type::file) {
    const std::string stem = std::filesystem::path(std::get<std::string>(value)).stem().string();
    return stem.empty() ? "none" : stem;
  }
  return std::visit([](const auto& v) { return fmt::format("{}", v); }, value);
}

// Whether the setting in this row of the table tells choices of one type apart.
bool is_telling(const Choice& choice, std::size_t row, std::span<const Choice> all) {
  const Value& value = choice.cells[row].value;
  if (value != default_cell(choice.table[row]).value) return true;
  return std::any_of(all.begin(), all.end(), [&](const Choice& other) {
    return other.plugin == choice.plugin && other.cells[row].value != value;
  });
}

std::string name_of(const Choice& choice, std::span<const Choice> all) {
  std::string settings;
  for (std::size_t row = 0; row < choice.table.size(); ++row) {
    const Cell& cell = choice.cells[row];
    const bool is_shown = choice.label.empty() ? is_telling(choice, row, all) : cell.is_of_grid;
    if (!is_shown) continue;
    settings += fmt::format("{}{}={}", settings.empty() ? "" : ",", choice.table[row].name,
                            short_form(choice.table[row], cell.value));
  }
  const std::string& start = choice.label.empty() ? choice.plugin->name : choice.label;
  return settings.empty() ? start : fmt::format("{}[{}]", start, settings);
}

}  // namespace

std::string name_problem(std::string_view name) {
  constexpr std::size_t longest = 255;  // what file systems allow
  const auto is_control = [](unsigned char c) { return c < 32 || c == 127; };
  if (name.empty() || name == "." || name == "..") return "a name is a folder's too";
  if (name.find('/') != std::string_view::npos) return "a name is a folder's too, without \"/\"";
  if (std::any_of(name.begin(), name.end(), is_control)) return "a name is a folder's too, without control characters";
  if (name.size() > longest) return fmt::format("a name is a folder's too, of at most {} bytes", longest);
  return "";
}

void name_choices(std::span<Choice> choices, std::string_view noun, Problems& problems) {
  std::map<std::string, const Choice*> first_of_name;
  for (Choice& choice : choices) {
    choice.name = name_of(choice, choices);
    const std::string problem = name_problem(choice.name);
    if (!problem.empty()) {
      problems.add(choice.place, choice.path,
                   fmt::format("is called {}; {}: give it another \"label\"", in_quotes(choice.name), problem));
    }
    const auto [first, is_new] = first_of_name.try_emplace(choice.name, &choice);
    if (is_new) continue;
    const std::string where = first->second->place.line > 0 ? fmt::format(", line {}", first->second->place.line) : "";
    problems.add(choice.place, choice.path,
                 fmt::format("is a second {} called {} (the first is {}{}); give one of them a \"label\"", noun,
                             in_quotes(choice.name), first->second->path, where));
  }
}

}  // namespace moire
