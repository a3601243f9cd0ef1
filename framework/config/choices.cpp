// Reads entries and turns what was read into what the program and the written request hold.
#include "config/choices.h"

#include <algorithm>

#include <fmt/format.h>

#include "config/experiment_format.h"
#include "config/naming.h"
#include "json/nearest_name.h"

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

// The first row behind the plugin's own: its options.
std::size_t options_begin(const Choice& choice) { return choice.plugin->parameters().size(); }

// The lookup or the filter; empty where the plugin takes none.
const std::string& chosen(const Choice& choice, std::string_view key) {
  static const std::string none;
  for (std::size_t row = options_begin(choice); row < choice.table.size(); ++row) {
    if (choice.table[row].name == key) return std::get<std::string>(choice.cells[row].value);
  }
  return none;
}

// The rows from `begin` on that have an effect.
std::pair<std::vector<Parameter>, Cells> with_effect(const Choice& choice, std::size_t begin) {
  std::pair<std::vector<Parameter>, Cells> result;
  for (std::size_t row = begin; row < choice.table.size(); ++row) {
    if (!has_effect(choice, row)) continue;
    result.first.push_back(choice.table[row]);
    result.second.push_back(choice.cells[row]);
  }
  return result;
}

// Whether anything was changed.
bool unset_without_effect(Choice& choice) {
  bool is_changed = false;
  for (std::size_t row = options_begin(choice); row < choice.table.size(); ++row) {
    const Cell unset = default_cell(choice.table[row]);
    if (has_effect(choice, row) || choice.cells[row].value == unset.value) continue;
    choice.cells[row] = unset;
    is_changed = true;
  }
  return is_changed;
}

// In a grid, options of one lookup stand beside those of another: each choice keeps what has an effect on it, and
// choices that are then the same become one. What has an effect on none is a problem.
void drop_options_without_effect(std::vector<Choice>& choices, Problems& problems) {
  if (choices.empty()) return;
  for (std::size_t row = options_begin(choices.front()); row < choices.front().table.size(); ++row) {
    const Parameter& parameter = choices.front().table[row];
    const Cell unset = default_cell(parameter);
    const bool is_given =
        std::any_of(choices.begin(), choices.end(), [&](const Choice& c) { return c.cells[row].value != unset.value; });
    const bool is_used =
        std::any_of(choices.begin(), choices.end(), [&](const Choice& c) { return has_effect(c, row); });
    if (is_given && !is_used) {
      const std::string_view group = parameter.name.substr(0, parameter.name.find('.'));
      problems.add(choices.front().place, member_path(choices.front().path, parameter.name),
                   fmt::format("has no effect without \"{}\" as lookup or filter; choose that or remove this", group));
    }
  }
  // What the entry itself says twice stays twice, and is refused for its name.
  std::vector<Choice> different;
  std::vector<bool> was_changed;
  for (Choice& choice : choices) {
    const bool is_changed = unset_without_effect(choice);
    bool is_new = true;
    for (std::size_t k = 0; k < different.size() && is_new; ++k) {
      is_new = !(is_changed || was_changed[k]) ||
               !std::equal(choice.cells.begin(), choice.cells.end(), different[k].cells.begin(),
                           [](const Cell& x, const Cell& y) { return x.value == y.value; });
    }
    if (!is_new) continue;
    different.push_back(std::move(choice));
    was_changed.push_back(is_changed);
  }
  choices = std::move(different);
}

// A plugin from elsewhere may want a lookup that this program does not have.
void refuse_unknown_lookup(const Choice& choice, const ChoiceContext& context) {
  if (choice.plugin->sampler == nullptr) return;
  const auto known = format::words(context.options.lookups);
  const std::string& lookup = chosen(choice, format::lookup_key);
  if (std::find(known.begin(), known.end(), lookup) != known.end()) return;
  context.reading.problems.add(choice.place, choice.path,
                               fmt::format("there is no lookup \"{}\", the default of \"{}\"; known are {}", lookup,
                                           choice.plugin->name, listed(known)));
}

// Such a key is not unknown, it is in the wrong place.
void refuse_filter(const JsonNode& entry, const std::string& path, const Plugin& plugin, Problems& problems) {
  const JsonNode* filter = entry.find(format::filter_key);
  if (filter == nullptr) return;
  problems.add(filter->place, member_path(path, format::filter_key),
               fmt::format("is {}, but \"{}\" weighs pixels itself and takes no filter; remove this", shown(*filter),
                           plugin.name));
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

bool has_effect(const Choice& choice, std::size_t row) {
  if (row < options_begin(choice)) return true;
  const std::string_view name = choice.table[row].name, group = name.substr(0, name.find('.'));
  return group.size() == name.size() || group == chosen(choice, format::lookup_key) ||
         group == chosen(choice, format::filter_key);
}

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
  const auto table = format::parameters_of(*plugin, context.vocabulary, context.options);
  std::vector<std::string_view> other_keys{"label", "type", "use"};
  const bool is_contender = kind == Kind::sampler && takes_grids;
  if (is_contender) other_keys.insert(other_keys.end(), {format::if_installed.name, format::if_it_fits.name});
  const bool takes_no_filter = kind == Kind::sampler && !format::takes_filters(*plugin->sampler);
  if (takes_no_filter) {
    refuse_filter(entry, path, *plugin, context.reading.problems);
    other_keys.push_back(format::filter_key);
  }
  const auto label = read_label(entry, path, context.reading.problems);
  const auto combinations = read_settings(entry, path, {plugin->name, table, other_keys, takes_grids}, context.reading);
  if (!label) return {};
  std::vector<Choice> choices;
  const bool if_it_fits = is_contender && read_flag(entry, path, format::if_it_fits, context.reading);
  for (const Cells& cells : combinations)
    choices.push_back({entry.place, path, plugin, table, cells, *label, "", if_it_fits});
  for (const Choice& choice : choices) refuse_unknown_lookup(choice, context);
  if (kind == Kind::sampler) drop_options_without_effect(choices, context.reading.problems);
  return choices;
}

SceneChoice scene_of(const Choice& choice) {
  return {choice.name, choice.plugin, settings_of(choice.table, choice.cells)};
}

SamplerChoice sampler_of(const Choice& choice) {
  const std::span<const Parameter> own = std::span(choice.table).first(options_begin(choice));
  SamplerChoice sampler{choice.name, choice.plugin, settings_of(own, choice.cells), chosen(choice, format::lookup_key)};
  if (const std::string& filter = chosen(choice, format::filter_key); !filter.empty()) sampler.filter = filter;
  const auto [table, cells] = with_effect(choice, own.size());
  sampler.options = settings_of(table, cells);
  return sampler;
}

nlohmann::ordered_json written(const Choice& choice) {
  nlohmann::ordered_json object = {{"type", choice.plugin->name}, {"label", choice.name}};
  if (choice.if_it_fits) object[std::string(format::if_it_fits.name)] = true;
  const auto [table, cells] = with_effect(choice, 0);
  write_settings(table, cells, object);
  return object;
}

}  // namespace moire
