// Collects problems and throws them together.
#include "json/problems.h"

#include <algorithm>
#include <cctype>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <moire/error.h>
#include <nlohmann/json.hpp>

namespace moire {
namespace {

constexpr std::size_t longest_text = 60;  // shown in a message

}  // namespace

std::string in_quotes(std::string_view text) {
  const std::string start(text.substr(0, longest_text));
  // A cut may split a character: `ignore` drops what is left of it.
  std::string result = nlohmann::json(start).dump(-1, ' ', false, nlohmann::json::error_handler_t::ignore);
  if (text.size() > longest_text) result.insert(result.size() - 1, "...");
  return result;
}

std::string member_path(std::string_view path, std::string_view key) {
  const auto is_plain = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '.' || c == '$'; };
  const bool is_short = key.size() <= longest_text;
  const std::string step =
      is_short && std::all_of(key.begin(), key.end(), is_plain) ? std::string(key) : in_quotes(key);
  return path.empty() ? step : fmt::format("{}.{}", path, step);
}

std::string item_path(std::string_view path, std::size_t index) { return fmt::format("{}[{}]", path, index); }

std::string problem_at(const Place& place, std::string_view path, std::string_view what) {
  const std::string line = place.line > 0 ? fmt::format(":{}", place.line) : "";
  const std::string inside = path.empty() ? "" : fmt::format("{}: ", path);
  return fmt::format("{}{}: {}{}", place.source->shown, line, inside, what);
}

void Problems::add(const Place& place, std::string_view path, std::string_view what) {
  const Source& source = *place.source;
  const std::string_view in_entry = path.substr(source.is_shared ? path.find(']') + 1 : 0);
  Problem problem{source.shown, place.line, fmt::format("{}: {}", in_entry, what), problem_at(place, path, what)};
  const bool is_new = std::none_of(problems_.begin(), problems_.end(), [&](const Problem& other) {
    return std::tie(other.source, other.line, other.fault) == std::tie(problem.source, problem.line, problem.fault);
  });
  if (is_new) problems_.push_back(std::move(problem));
}

void Problems::throw_if_any() const {
  if (problems_.empty()) return;
  std::vector<Problem> sorted = problems_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Problem& a, const Problem& b) {
    return std::tie(a.source, a.line) < std::tie(b.source, b.line);
  });
  std::string message;
  for (const Problem& problem : sorted) message += (message.empty() ? "" : "\n") + problem.text;
  throw Error(message);
}

}  // namespace moire
