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

// Of each type the rows of its table in which its choices without a label differ.
using Differences = std::map<const Plugin*, std::vector<bool>>;

Differences differences(std::span<const Choice> choices) {
  Differences result;
  std::map<const Plugin*, const Choice*> firsts;
  for (const Choice& choice : choices) {
    if (!choice.label.empty()) continue;
    const Choice& first = *firsts.try_emplace(choice.plugin, &choice).first->second;
    std::vector<bool>& rows = result.try_emplace(choice.plugin, choice.table.size()).first->second;
    for (std::size_t row = 0; row < rows.size(); ++row) {
      if (choice.cells[row].value != first.cells[row].value) rows[row] = true;
    }
  }
  return result;
}

bool is_shown(const Choice& choice, std::size_t row, const Differences& differing) {
  if (!has_effect(choice, row)) return false;
  if (!choice.label.empty()) return choice.cells[row].is_of_grid;
  return differing.at(choice.plugin)[row] || choice.cells[row].value != default_cell(choice.table[row]).value;
}

std::string name_of(const Choice& choice, const Differences& differing) {
  std::string settings;
  for (std::size_t row = 0; row < choice.table.size(); ++row) {
    if (!is_shown(choice, row, differing)) continue;
    settings += fmt::format("{}{}={}", settings.empty() ? "" : ",", choice.table[row].name,
                            short_form(choice.table[row], choice.cells[row].value));
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
  const Differences differing = differences(choices);
  std::map<std::string, const Choice*> first_of_name;
  for (Choice& choice : choices) {
    choice.name = name_of(choice, differing);
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
