// Reads the paths and values of --set and puts them into the tree.
#include "config/overrides.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <utility>
#include <variant>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace moire {
namespace {

using Step = std::variant<std::string, std::size_t>;  // a key, or the index of an item

// The next step of "samplers[1].n", taken off its front; nothing if it is no path. `is_first`: no dot stands before it.
std::optional<Step> take_step(std::string_view& path, bool is_first) {
  if (path.starts_with('[') && !is_first) {
    std::size_t index = 0;
    const char* const end = path.data() + path.size();
    const auto [behind, error] = std::from_chars(path.data() + 1, end, index);
    if (error != std::errc() || behind == end || *behind != ']') return std::nullopt;
    path.remove_prefix(static_cast<std::size_t>(behind + 1 - path.data()));
    return index;
  }
  if (!is_first && !path.starts_with('.')) return std::nullopt;
  path.remove_prefix(is_first ? 0 : 1);
  const std::string key(path.substr(0, path.find_first_of(".[")));
  if (key.empty()) return std::nullopt;
  path.remove_prefix(key.size());
  return key;
}

// VALUE as JSON, or else as a text.
std::optional<JsonNode> parse_value(const std::string& text, const std::shared_ptr<const Source>& source,
                                    std::string_view path, Problems& problems) {
  Problems of_value;
  std::optional<JsonNode> value = parse_json(text, source, path, of_value);
  if (value) {
    problems.append(of_value);
    return value;
  }
  try {
    (void)nlohmann::json(text).dump();
  } catch (const nlohmann::json::type_error&) {
    problems.add({source, 0}, path, "its value is not in UTF-8");
    return std::nullopt;
  }
  JsonNode node;
  node.kind = JsonKind::text;
  node.place = {source, 0};
  node.text = text;
  return node;
}

class Walk {
 public:
  Walk(JsonNode& root, const Place& place, Problems& problems) : at_(&root), place_(place), problems_(problems) {}

  // False after a problem was added.
  bool enter(const Step& step) {
    const bool is_key = std::holds_alternative<std::string>(step);
    return is_key ? enter_member(std::get<std::string>(step)) : enter_item(std::get<std::size_t>(step));
  }
  JsonNode& node() { return *at_; }

 private:
  bool enter_member(const std::string& key) {
    if (!at_->is(JsonKind::object)) return lead_nowhere(fmt::format("has no members such as \"{}\"", key));
    path_ = member_path(path_, key);
    JsonNode* value = at_->find(key);
    if (value == nullptr) {
      value = &at_->members.emplace_back(JsonMember{key, place_, {}}).value;
      value->kind = JsonKind::object;
      value->place = place_;
    }
    at_ = value;
    return true;
  }

  bool enter_item(std::size_t index) {
    if (!at_->is(JsonKind::list)) return lead_nowhere("is no list");
    const std::size_t size = at_->items.size();
    if (index >= size)
      return lead_nowhere(fmt::format("has {} {}, counted from 0", size, size == 1 ? "item" : "items"));
    path_ = item_path(path_, index);
    at_ = &at_->items[index];
    return true;
  }

  bool lead_nowhere(std::string_view why) {
    problems_.add(place_, "", fmt::format("leads nowhere: \"{}\" {}", path_, why));
    return false;
  }

  JsonNode* at_;
  Place place_;
  Problems& problems_;
  std::string path_;
};

void apply_set(const std::string& set, JsonNode& root, Problems& problems) {
  const Place place{std::make_shared<Source>(Source{"--set " + set, std::filesystem::current_path(), false}), 0};
  const std::size_t equals = set.find('=');
  if (equals == std::string::npos) return problems.add(place, "", "has no \"=\"; write --set PATH=VALUE");
  const std::string path = set.substr(0, equals);

  std::vector<Step> steps;
  for (std::string_view rest = path; !rest.empty() || steps.empty();) {
    const auto step = take_step(rest, steps.empty());
    if (!step) return problems.add(place, "", fmt::format("\"{}\" is no path; write such as samplers[1].n", path));
    steps.push_back(*step);
  }

  const auto value = parse_value(set.substr(equals + 1), place.source, path, problems);
  if (!value) return;
  Walk walk(root, place, problems);
  if (std::all_of(steps.begin(), steps.end(), [&](const Step& step) { return walk.enter(step); })) walk.node() = *value;
}

}  // namespace

void apply_sets(std::span<const std::string> sets, JsonNode& root, Problems& problems) {
  for (const std::string& set : sets) apply_set(set, root, problems);
}

}  // namespace moire
