// Reads "metrics" and "pictures".
#include "config/pass_choices.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "config/choices.h"
#include "config/experiment_format.h"
#include "json/nearest_name.h"

namespace moire {
namespace {

const PassDescription* find_pass(std::string_view name, const PassList& passes) {
  const auto found = std::find_if(passes.known.begin(), passes.known.end(),
                                  [&](const PassDescription* pass) { return pass->name == name; });
  return found == passes.known.end() ? nullptr : *found;
}

void refuse_pass(const JsonNode& type, const std::string& path, const PassList& passes, Problems& problems) {
  std::vector<std::string_view> known;
  for (const PassDescription* pass : passes.known) known.push_back(pass->name);
  problems.add(type.place, member_path(path, "type"),
               fmt::format("there is no {} {}{} known are {}", passes.noun, shown(type), did_you_mean(type.text, known),
                           known.empty() ? "none" : listed(known)));
}

const PassDescription* pass_of(const JsonNode& entry, const std::string& path, const PassList& passes,
                               Problems& problems) {
  const JsonNode* type = entry_type(entry, path, passes.noun, problems);
  if (type == nullptr) return nullptr;
  const PassDescription* pass = find_pass(type->text, passes);
  if (pass == nullptr) refuse_pass(*type, path, passes, problems);
  return pass;
}

std::optional<PassEntry> read_pass(const JsonNode& entry, const std::string& path, const PassDescription& pass,
                                   const Reading& reading) {
  constexpr std::string_view other_keys[] = {"type"};
  const auto cells = read_settings(entry, path, {pass.name, pass.parameters, other_keys}, reading);
  if (cells.empty()) return std::nullopt;
  nlohmann::ordered_json written = {{"type", pass.name}};
  write_settings(pass.parameters, cells.front(), written);
  return PassEntry{entry.place,
                   path,
                   &pass,
                   {std::string(pass.name), settings_of(pass.parameters, cells.front())},
                   std::move(written)};
}

// The rows of a metric are named after it, so that it can be there only once.
void refuse_second(const JsonNode& entry, const std::string& path, const JsonNode& first, const std::string& first_path,
                   std::string_view name, Problems& problems) {
  const std::string line = first.place.line > 0 ? fmt::format(", line {}", first.place.line) : "";
  problems.add(
      entry.place, path,
      fmt::format("is a second \"{}\" (the first is {}{}), whose numbers would have the same names; remove one "
                  "of them",
                  name, first_path, line));
}

JsonNode default_passes(std::string_view pass, const Place& place) {
  JsonNode name, entry, list;
  name.kind = JsonKind::text;
  name.text = pass;
  entry.kind = JsonKind::object;
  list.kind = JsonKind::list;
  name.place = entry.place = list.place = place;
  entry.members.push_back({"type", place, name});
  list.items.push_back(entry);
  return list;
}

}  // namespace

std::vector<PassEntry> read_passes(const JsonNode* list, const Place& root, const PassList& passes,
                                   const Reading& reading) {
  const JsonNode defaults = passes.unless_given.empty() ? JsonNode() : default_passes(passes.unless_given, root);
  const std::vector<JsonNode>& entries = list ? list->items : defaults.items;
  std::vector<PassEntry> result;
  std::map<const PassDescription*, std::size_t> first;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::string path = item_path(passes.key, i);
    const PassDescription* pass = pass_of(entries[i], path, passes, reading.problems);
    if (pass == nullptr) continue;
    const auto [found, is_new] = first.try_emplace(pass, i);
    if (passes.once && !is_new) {
      const std::size_t k = found->second;
      refuse_second(entries[i], path, entries[k], item_path(passes.key, k), pass->name, reading.problems);
    }
    if (auto read = read_pass(entries[i], path, *pass, reading)) result.push_back(*std::move(read));
  }
  return result;
}

}  // namespace moire
