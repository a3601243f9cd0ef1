// Walks an object along a parameter table.
#include "config/settings_reader.h"

#include <algorithm>

#include <fmt/format.h>

#include "config/experiment_format.h"
#include "json/nearest_name.h"

namespace moire {
namespace {

constexpr std::size_t most_combinations = 10000;  // of one grid: what a slip of the pen must not fill the memory with

class SettingsReader {
 public:
  SettingsReader(const std::string& path, const SettingsOwner& owner, const Reading& reading)
      : path_(path), owner_(owner), reading_(reading), columns_(owner.table.size()) {}

  // Reads the members that stand under `prefix` ("" or "view.").
  void read_members(const JsonNode& object, const std::string& prefix) {
    for (const JsonMember& member : object.members) {
      if (prefix.empty() && is_other_key(member.key)) continue;
      const std::string name = prefix + member.key;
      const bool is_plain = member.key.find('.') == std::string::npos;
      if (const Parameter* parameter = is_plain ? find(name) : nullptr) {
        read_parameter(*parameter, member.value);
      } else if (is_plain && has_group(name)) {
        read_group(member.value, name);
      } else {
        refuse_key(member, prefix);
      }
    }
  }

  std::vector<Cells> combinations(const Place& place) {
    if (!is_good_) return {};
    std::size_t count = 1;
    for (std::size_t i = 0; i < columns_.size() && count <= most_combinations; ++i) {
      if (columns_[i].empty()) columns_[i].push_back(default_cell(owner_.table[i]));
      count *= columns_[i].size();
    }
    if (count > most_combinations) {
      problem(place, path_,
              fmt::format("its lists make too many combinations; at most {} are allowed", most_combinations));
      return {};
    }
    std::vector<Cells> result(1);
    for (const std::vector<Cell>& column : columns_) result = times(result, column);
    return result;
  }

 private:
  static std::vector<Cells> times(const std::vector<Cells>& rows, const std::vector<Cell>& column) {
    std::vector<Cells> result;
    for (const Cells& row : rows) {
      for (const Cell& cell : column) result.emplace_back(row).push_back(cell);
    }
    return result;
  }

  void read_parameter(const Parameter& parameter, const JsonNode& node) {
    const std::string path = member_path(path_, parameter.name);
    std::vector<Cell>& column = columns_[static_cast<std::size_t>(&parameter - owner_.table.data())];
    if (!node.is(JsonKind::list)) return add(column, node, path, parameter);
    if (!owner_.takes_grids) return problem(node.place, path, "is a list; it takes one value here");
    if (node.items.empty()) return problem(node.place, path, "is an empty list; a grid has at least one value");
    for (std::size_t i = 0; i < node.items.size(); ++i) add(column, node.items[i], item_path(path, i), parameter);
    for (Cell& cell : column) cell.is_of_grid = true;
  }

  void add(std::vector<Cell>& column, const JsonNode& node, const std::string& path, const Parameter& parameter) {
    auto cell = read_value(node, path, parameter, owner_.name, reading_);
    is_good_ = is_good_ && cell;
    if (cell) column.push_back(*std::move(cell));
  }

  void read_group(const JsonNode& node, const std::string& name) {
    if (node.is(JsonKind::object)) return read_members(node, name + ".");
    problem(node.place, member_path(path_, name),
            fmt::format("is {}; it takes an object with {}", shown(node), listed(keys(name + "."))));
  }

  void refuse_key(const JsonMember& member, const std::string& prefix) {
    std::vector<std::string_view> known = keys(prefix), meant = known;
    const std::string_view group = std::string_view(prefix).substr(0, prefix.empty() ? 0 : prefix.size() - 1);
    if (prefix.empty()) {
      for (const std::string_view key : owner_.other_keys) {
        // Where a filter is no row of the table there is none to be chosen.
        if (key != format::filter_key) meant.push_back(key);
        // The type is there already, `use` has been followed, and whether it is installed is known.
        if (key == "label") known.push_back(key);
      }
    }
    const std::string hint = did_you_mean(member.key, meant);
    const std::string takes = known.empty() ? "no parameters" : listed(known);
    problem(member.place, member_path(path_, prefix + member.key),
            fmt::format("unknown key{} \"{}\" takes {}", hint, group.empty() ? owner_.name : group, takes));
  }

  bool is_other_key(std::string_view key) const {
    return std::find(owner_.other_keys.begin(), owner_.other_keys.end(), key) != owner_.other_keys.end();
  }
  const Parameter* find(std::string_view name) const {
    const auto found = std::find_if(owner_.table.begin(), owner_.table.end(),
                                    [&](const Parameter& parameter) { return parameter.name == name; });
    return found == owner_.table.end() ? nullptr : &*found;
  }
  bool has_group(const std::string& name) const { return !keys(name + ".").empty(); }

  // What may stand under a prefix: of "view.pitch_deg", "view" under "", and "pitch_deg" under "view.".
  std::vector<std::string_view> keys(const std::string& prefix) const {
    std::vector<std::string_view> result;
    for (const Parameter& parameter : owner_.table) {
      if (!parameter.name.starts_with(prefix)) continue;
      const std::string_view rest = parameter.name.substr(prefix.size());
      const std::string_view key = rest.substr(0, rest.find('.'));
      if (std::find(result.begin(), result.end(), key) == result.end()) result.push_back(key);
    }
    return result;
  }

  void problem(const Place& place, const std::string& path, std::string_view what) {
    reading_.problems.add(place, path, what);
    is_good_ = false;
  }

  const std::string& path_;
  const SettingsOwner& owner_;
  const Reading& reading_;
  std::vector<std::vector<Cell>> columns_;  // the values of each row of the table
  bool is_good_ = true;
};

}  // namespace

std::vector<Cells> read_settings(const JsonNode& object, const std::string& path, const SettingsOwner& owner,
                                 const Reading& reading) {
  SettingsReader reader(path, owner, reading);
  reader.read_members(object, "");
  return reader.combinations(object.place);
}

Settings settings_of(std::span<const Parameter> table, const Cells& cells) {
  Settings settings(table);
  for (std::size_t i = 0; i < table.size(); ++i) settings.set(table[i].name, cells[i].value);
  return settings;
}

void write_settings(std::span<const Parameter> table, const Cells& cells, nlohmann::ordered_json& object) {
  for (std::size_t i = 0; i < table.size(); ++i) {
    nlohmann::ordered_json* at = &object;
    std::string_view rest = table[i].name;
    for (std::size_t dot = rest.find('.'); dot != std::string_view::npos; dot = rest.find('.')) {
      at = &(*at)[std::string(rest.substr(0, dot))];
      rest.remove_prefix(dot + 1);
    }
    (*at)[std::string(rest)] = cells[i].written;
  }
}

}  // namespace moire
