// Nested JSON as a list of names and texts.
#include "report/flattened.h"

#include <algorithm>

namespace moire::report {
namespace {

using Json = nlohmann::ordered_json;
using Entries = std::vector<std::pair<std::string, std::string>>;

std::string text_of(const Json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

bool is_plain_list(const Json& value) {
  return value.is_array() && std::none_of(value.begin(), value.end(), [](auto& v) { return v.is_structured(); });
}

std::string joined(const Json& list) {
  std::string text;
  for (const Json& value : list) text += (text.empty() ? "" : ", ") + text_of(value);
  return text;
}

void append(Entries& entries, const std::string& name, const Json& value) {
  if (is_plain_list(value)) {
    entries.emplace_back(name, joined(value));
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) append(entries, name + '[' + std::to_string(i) + ']', value[i]);
  } else if (value.is_object()) {
    for (const auto& [key, member] : value.items()) append(entries, name.empty() ? key : name + '.' + key, member);
  } else {
    entries.emplace_back(name, text_of(value));
  }
}

}  // namespace

Entries flattened(const Json& json) {
  Entries entries;
  if (!json.is_null()) append(entries, "", json);
  return entries;
}

}  // namespace moire::report
