// Reads entries and turns what was read into what the program and the written request hold.
#include "config/choices.h"

#include <algorithm>

#include <fmt/format.h>

#include "config/experiment_format.h"
#include "config/naming.h"
#include "config/nearest_name.h"

namespace moire {
namespace {

std::string_view noun_of(Kind kind) { return kind == Kind::scene ? "scene" : "sampler"; }

std::vector<std::string_view> names_of(const std::vector<const Plugin*>& plugins) {
  std::vector<std::string_view> names;
  for (const Plugin* plugin : plugins) names.push_back(plugin->name);
  return names;
}

const Plugin* read_plugin(const JsonNode& entry, const std::string& path, Kind kind, const ChoiceContext& context) {
  const JsonNode* type = entry_type(entry, path, noun_of(kind), context.reading.problems);
  if (type == nullptr) return nullptr;
  const Catalog& catalog = *context.vocabulary.catalog;
  if (const Plugin* plugin = catalog.find(kind, type->text)) return plugin;
  const auto known = names_of(catalog.all(kind));
  context.reading.problems.add(type->place, member_path(path, "type"),
                               fmt::format("there is no {} {}{} known are {}", noun_of(kind), shown(*type),
                                           did_you_mean(type->text, known), known.empty() ? "none" : listed(known)));
  return nullptr;
}

// A plugin from elsewhere may want a lookup that this program does not have.
void refuse_unknown_lookup(const Choice& choice, const ChoiceContext& context) {
  if (choice.plugin->sampler == nullptr) return;
  const auto known = format::words(context.lookups);
  const std::string& lookup = std::get<std::string>(choice.cells.back().value);
  if (std::find(known.begin(), known.end(), lookup) != known.end()) return;
  context.reading.problems.add(choice.place, choice.path,
                               fmt::format("there is no lookup \"{}\", the default of \"{}\"; known are {}", lookup,
                                           choice.plugin->name, listed(known)));
}

// Nothing after adding a problem; empty if there is no label.
std::optional<std::string> read_label(const JsonNode& entry, const std::string& path, Problems& problems) {
  const JsonNode* label = entry.find("label");
  if (label == nullptr) return "";
  const std::string problem = label->is(JsonKind::text) ? name_problem(label->text) : "a label is a text";
  if (problem.empty()) return label->text;
  problems.add(label->place, member_path(path, "label"), fmt::format("is {}; {}", shown(*label), problem));
  return std::nullopt;
}

// A flag of a sampler's entry; false where there is none or after adding a problem.
bool read_flag(const JsonNode& entry, const std::string& path, const Parameter& key, const Reading& reading) {
  const JsonNode* node = entry.find(key.name);
  if (node == nullptr) return false;
  const auto cell = read_value(*node, member_path(path, key.name), key, "sampler", reading);
  return cell && std::get<bool>(cell->value);
}

}  // namespace

const JsonNode* entry_type(const JsonNode& entry, const std::string& path, std::string_view noun, Problems& problems) {
  if (entry.is(JsonKind::broken)) return nullptr;
  if (!entry.is(JsonKind::object)) {
    problems.add(entry.place, path,
                 fmt::format("is {}; a {} is a name, or an object with a \"type\"", shown(entry), noun));
    return nullptr;
  }
  const JsonNode* type = entry.find("type");
  if (type == nullptr) {
    problems.add(entry.place, path, fmt::format("has no \"type\"; a {} is a name, or an object with a \"type\"", noun));
  } else if (!type->is(JsonKind::text)) {
    problems.add(type->place, member_path(path, "type"),
                 fmt::format("is {}; a type is the name of a {}", shown(*type), noun));
    type = nullptr;
  }
  return type;
}

bool is_left_out(const JsonNode& entry, const std::string& path, const ChoiceContext& context) {
  if (!read_flag(entry, path, format::if_installed, context.reading)) return false;
  const JsonNode* type = entry.find("type");
  return type != nullptr && type->is(JsonKind::text) &&
         context.vocabulary.catalog->find(Kind::sampler, type->text) == nullptr;
}

std::vector<Choice> read_entry(const JsonNode& entry, const std::string& path, Kind kind, bool takes_grids,
                               const ChoiceContext& context) {
  const Plugin* plugin = read_plugin(entry, path, kind, context);
  if (plugin == nullptr) return {};
  const auto table = format::parameters_of(*plugin, context.lookups);
  std::vector<std::string_view> other_keys{"label", "type", "use"};
  const bool is_contender = kind == Kind::sampler && takes_grids;
  if (is_contender) other_keys.insert(other_keys.end(), {format::if_installed.name, format::if_it_fits.name});
  const auto label = read_label(entry, path, context.reading.problems);
  const auto combinations = read_settings(entry, path, {plugin->name, table, other_keys, takes_grids}, context.reading);
  if (!label) return {};
  std::vector<Choice> choices;
  const bool if_it_fits = is_contender && read_flag(entry, path, format::if_it_fits, context.reading);
  for (const Cells& cells : combinations)
    choices.push_back({entry.place, path, plugin, table, cells, *label, "", if_it_fits});
  for (const Choice& choice : choices) refuse_unknown_lookup(choice, context);
  return choices;
}

SceneChoice scene_of(const Choice& choice) {
  return {choice.name, choice.plugin, settings_of(choice.table, choice.cells)};
}

SamplerChoice sampler_of(const Choice& choice) {
  const std::span<const Parameter> all(choice.table);
  return {choice.name, choice.plugin, settings_of(all.first(all.size() - 1), choice.cells),
          std::get<std::string>(choice.cells.back().value)};
}

nlohmann::ordered_json written(const Choice& choice) {
  nlohmann::ordered_json object = {{"type", choice.plugin->name}, {"label", choice.name}};
  if (choice.if_it_fits) object[std::string(format::if_it_fits.name)] = true;
  write_settings(choice.table, choice.cells, object);
  return object;
}

}  // namespace moire
