// JSON files of scenes: values that know the line they stand on, so that wrong ones are refused as in experiments.
#pragma once

#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>

#include <moire/color.h>

namespace moire {

struct JsonNode;

// One value of a document. It refers to the document. Every Error reads `file:line: path: what is wrong (found); what
// would be right`.
class DocumentValue {
 public:
  // Of an object; Error: it is none, or has no such member.
  DocumentValue operator[](std::string_view key) const;
  bool has(std::string_view key) const;
  // Error: this is no object, or has members other than these.
  void allow_only(std::initializer_list<std::string_view> keys) const;

  // Of a list; Error: it is none.
  std::size_t size() const;
  DocumentValue operator[](std::size_t index) const;

  // Error: it is no number, or not in smallest .. largest.
  double number(double smallest, double largest) const;
  // Error: it is not true or false.
  bool flag() const;
  // Error: it is no text.
  const std::string& text() const;
  // Error: it is none of these. Its place among them.
  std::size_t choice(std::initializer_list<std::string_view> names) const;
  // "#rrggbb" in sRGB, as linear light. Error: it is something else.
  Color color() const;

  // Error: `what` is wrong here.
  [[noreturn]] void refuse(std::string_view what) const;

 private:
  friend class Document;
  DocumentValue(const JsonNode& node, std::string path) : node_(&node), path_(std::move(path)) {}

  const JsonNode* node_;
  std::string path_;  // "lines[2].from"
};

class Document {
 public:
  // Error: the file cannot be read, or is not JSON; comments after // are allowed.
  explicit Document(const std::filesystem::path& file);
  // `name` stands for the file in messages.
  Document(std::string_view text, std::string_view name);
  ~Document();

  DocumentValue root() const;

 private:
  std::unique_ptr<const JsonNode> root_;
};

}  // namespace moire
