// JSON as a tree whose nodes know the line they stand on.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "json/problems.h"

namespace moire {

struct JsonMember;

// `broken` stands for what could not be read and was reported already: nothing more is said about it.
enum class JsonKind { broken, null, flag, integer, real, text, list, object };

struct JsonNode {
  JsonKind kind = JsonKind::broken;
  Place place;
  bool flag = false;
  std::int64_t integer = 0;
  double real = 0;   // of integers too
  std::string text;  // of numbers as they were written
  std::vector<JsonNode> items;
  std::vector<JsonMember> members;

  bool is(JsonKind k) const { return kind == k; }
  bool is_number() const { return kind == JsonKind::integer || kind == JsonKind::real; }
  const JsonNode* find(std::string_view key) const;  // null if there is none, or this is no object
  JsonNode* find(std::string_view key);
};

struct JsonMember {
  std::string key;
  Place place;  // of the key
  JsonNode value;
};

// Reads one JSON value; // comments are allowed. A syntax error is a problem, and then there is no tree. A repeated key
// is a problem too, and only its first value stays. `path` is where the value will stand in the experiment.
std::optional<JsonNode> parse_json(std::string_view text, std::shared_ptr<const Source> source, std::string_view path,
                                   Problems& problems);

// What was found, for messages: `0`, `"gird"`, `a list`.
std::string shown(const JsonNode& node);

}  // namespace moire
