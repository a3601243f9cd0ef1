// One function a keyword, as the draft describes it: a keyword says nothing of values of another type.
#include "schema_check.h"

#include <regex.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>

namespace moire::test {
namespace {

using Json = nlohmann::json;

struct Check {
  const Json& value;
  const Json& argument;  // of the keyword
  const Json& schema;    // that the keyword stands in
  const Json& root;

  bool holds(const Json& of, const Json& under) const { return is_valid(of, under, root); }
};

bool has_type(const Check& c) {
  const std::map<std::string, bool> types = {{"object", c.value.is_object()}, {"array", c.value.is_array()},
                                             {"string", c.value.is_string()}, {"boolean", c.value.is_boolean()},
                                             {"number", c.value.is_number()}, {"integer", c.value.is_number_integer()}};
  return types.at(c.argument);
}

bool properties_hold(const Check& c) {
  return !c.value.is_object() || std::all_of(c.argument.items().begin(), c.argument.items().end(), [&](const auto& p) {
    return !c.value.contains(p.key()) || c.holds(c.value[p.key()], p.value());
  });
}

bool has_no_additional(const Check& c) {
  if (!c.value.is_object() || c.argument == true) return true;
  return std::all_of(c.value.items().begin(), c.value.items().end(),
                     [&](const auto& member) { return c.schema.at("properties").contains(member.key()); });
}

bool has_required(const Check& c) {
  return !c.value.is_object() || std::all_of(c.argument.begin(), c.argument.end(),
                                             [&](const Json& key) { return c.value.contains(key.get<std::string>()); });
}

bool any_of_holds(const Check& c) {
  return std::any_of(c.argument.begin(), c.argument.end(),
                     [&](const Json& schema) { return c.holds(c.value, schema); });
}

bool items_hold(const Check& c) {
  return !c.value.is_array() ||
         std::all_of(c.value.begin(), c.value.end(), [&](const Json& item) { return c.holds(item, c.argument); });
}

bool refers(const Check& c) {
  return c.holds(c.value, c.root.at(Json::json_pointer(c.argument.get<std::string>().substr(1))));
}

// By POSIX: std::regex sets off false warnings under the sanitizers.
bool matches(const Check& c) {
  if (!c.value.is_string()) return true;
  regex_t pattern;
  if (regcomp(&pattern, c.argument.get<std::string>().c_str(), REG_EXTENDED | REG_NOSUB) != 0) {
    throw std::logic_error("no regular expression: " + c.argument.dump());
  }
  const bool is_match = regexec(&pattern, c.value.get<std::string>().c_str(), 0, nullptr, 0) == 0;
  regfree(&pattern);
  return is_match;
}

const std::map<std::string, bool (*)(const Check&)>& keywords() {
  static constexpr auto says_nothing = [](const Check&) { return true; };
  static const std::map<std::string, bool (*)(const Check&)> all = {
      {"$schema", says_nothing},
      {"title", says_nothing},
      {"description", says_nothing},
      {"default", says_nothing},
      {"definitions", says_nothing},
      {"$ref", refers},
      {"type", has_type},
      {"properties", properties_hold},
      {"additionalProperties", has_no_additional},
      {"required", has_required},
      {"anyOf", any_of_holds},
      {"items", items_hold},
      {"pattern", matches},
      {"not", [](const Check& c) { return !c.holds(c.value, c.argument); }},
      {"enum",
       [](const Check& c) { return std::find(c.argument.begin(), c.argument.end(), c.value) != c.argument.end(); }},
      {"const", [](const Check& c) { return c.value == c.argument; }},
      {"minimum", [](const Check& c) { return !c.value.is_number() || c.value >= c.argument; }},
      {"maximum", [](const Check& c) { return !c.value.is_number() || c.value <= c.argument; }},
      {"minItems", [](const Check& c) { return !c.value.is_array() || c.value.size() >= c.argument; }},
      {"minLength",
       [](const Check& c) { return !c.value.is_string() || c.value.get<std::string>().size() >= c.argument; }},
  };
  return all;
}

}  // namespace

bool is_valid(const Json& value, const Json& schema, const Json& root) {
  const auto members = schema.items();
  return std::all_of(members.begin(), members.end(), [&](const auto& keyword) {
    const auto check = keywords().find(keyword.key());
    if (check == keywords().end()) throw std::logic_error("unknown keyword " + keyword.key());
    return check->second({value, keyword.value(), schema, root});
  });
}

}  // namespace moire::test
