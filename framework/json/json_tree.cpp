// Builds the tree from nlohmann's parser, which reports what it reads as it reads it.
#include "json/json_tree.h"

#include <cstddef>
#include <iterator>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "json/json_syntax.h"

namespace moire {
namespace {

constexpr std::size_t deepest = 100;  // levels of nesting; bounds the recursion of all that walks a tree

// How far the parser has read.
struct Progress {
  std::size_t characters = 0;
  int line = 1;  // of the last character read: the parser looks one ahead after a number
  bool is_line_over = false;

  void pass(char c) {
    line += is_line_over ? 1 : 0;
    is_line_over = c == '\n';
    ++characters;
  }
};

// Hands characters to the parser and keeps count of them.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, Progress* progress) : at_(at), progress_(progress) {}

  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    progress_->pass(*at_++);
    return *this;
  }
  friend bool operator==(const CountingIterator& a, const CountingIterator& b) { return a.at_ == b.at_; }

 private:
  const char* at_;
  Progress* progress_;
};

class Builder final : public nlohmann::json_sax<nlohmann::json> {
 public:
  Builder(std::string_view text, std::shared_ptr<const Source> source, std::string_view path, Problems& problems)
      : text_(text), source_(std::move(source)), path_(path), problems_(problems) {}

  bool build() {
    const CountingIterator first(text_.data(), &progress_), last(text_.data() + text_.size(), &progress_);
    return nlohmann::json::sax_parse(first, last, this, nlohmann::json::input_format_t::json, true, true);
  }
  JsonNode& root() { return root_; }

  bool null() override { return put(JsonKind::null); }
  bool boolean(bool value) override {
    return put(JsonKind::flag, [&](JsonNode& n) { n.flag = value; });
  }
  bool number_integer(number_integer_t value) override { return put_integer(value, std::to_string(value)); }
  bool number_unsigned(number_unsigned_t value) override {
    if (std::in_range<std::int64_t>(value)) return put_integer(static_cast<std::int64_t>(value), std::to_string(value));
    return number_float(static_cast<double>(value), std::to_string(value));
  }
  bool number_float(number_float_t value, const string_t& written) override {
    return put(JsonKind::real, [&](JsonNode& n) { n.real = value, n.text = written; });
  }
  bool string(string_t& value) override {
    return put(JsonKind::text, [&](JsonNode& n) { n.text = value; });
  }
  bool binary(binary_t&) override { return false; }  // never called: JSON has none
  bool start_object(std::size_t) override { return open(JsonKind::object); }
  bool start_array(std::size_t) override { return open(JsonKind::list); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& value) override {
    open_.back()->members.push_back({value, here(), {}});
    return true;
  }

  bool parse_error(std::size_t, const std::string& token, const nlohmann::json::exception& error) override {
    const JsonNode* inner = open_.empty() ? nullptr : open_.back();
    problems_.add(here(), path_,
                  syntax_problem({.read = text_.substr(0, progress_.characters),
                                  .rest = text_.substr(progress_.characters),
                                  .token = token,
                                  .explanation = error.what(),
                                  .is_in_list = inner && inner->is(JsonKind::list),
                                  .open_since = inner ? inner->place.line : 0}));
    return false;
  }

 private:
  Place here() const { return {source_, source_->has_lines ? progress_.line : 0}; }

  // The node that the next value is: the root, a new item, or the value of the key just read.
  JsonNode& next() {
    JsonNode& node = open_.empty()                      ? root_
                     : open_.back()->is(JsonKind::list) ? open_.back()->items.emplace_back()
                                                        : open_.back()->members.back().value;
    node.place = here();
    return node;
  }

  template <class Fill>
  bool put(JsonKind kind, Fill fill) {
    JsonNode& node = next();
    node.kind = kind;
    fill(node);
    return true;
  }
  bool put(JsonKind kind) {
    return put(kind, [](JsonNode&) {});
  }
  bool put_integer(std::int64_t value, const std::string& written) {
    return put(JsonKind::integer,
               [&](JsonNode& n) { n.integer = value, n.real = static_cast<double>(value), n.text = written; });
  }

  bool open(JsonKind kind) {
    if (open_.size() == deepest) {
      problems_.add(here(), path_, fmt::format("is nested more than {} levels deep", deepest));
      return false;
    }
    JsonNode& node = next();
    node.kind = kind;
    open_.push_back(&node);
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  std::string_view text_;
  std::shared_ptr<const Source> source_;
  std::string_view path_;
  Problems& problems_;
  Progress progress_;
  JsonNode root_;
  std::vector<JsonNode*> open_;  // outermost first; their lists do not grow while they are open
};

// Reports keys that an object has twice, and keeps the first.
void drop_repeated_keys(JsonNode& node, const std::string& path, Problems& problems) {
  std::map<std::string, int, std::less<>> lines;
  std::erase_if(node.members, [&](const JsonMember& member) {
    const auto [first, is_new] = lines.try_emplace(member.key, member.place.line);
    if (is_new) return false;
    const std::string where = first->second > 0 ? fmt::format(" (first on line {})", first->second) : "";
    problems.add(member.place, member_path(path, member.key), fmt::format("repeated key{}; keep one of them", where));
    return true;
  });
  for (JsonMember& member : node.members) {
    drop_repeated_keys(member.value, member_path(path, member.key), problems);
  }
  for (std::size_t i = 0; i < node.items.size(); ++i) drop_repeated_keys(node.items[i], item_path(path, i), problems);
}

}  // namespace

JsonNode* JsonNode::find(std::string_view key) {
  for (JsonMember& member : members) {
    if (member.key == key) return &member.value;
  }
  return nullptr;
}

const JsonNode* JsonNode::find(std::string_view key) const { return const_cast<JsonNode*>(this)->find(key); }

std::optional<JsonNode> parse_json(std::string_view text, std::shared_ptr<const Source> source, std::string_view path,
                                   Problems& problems) {
  Builder builder(text, std::move(source), path, problems);
  if (!builder.build()) return std::nullopt;
  drop_repeated_keys(builder.root(), std::string(path), problems);
  return std::move(builder.root());
}

std::string shown(const JsonNode& node) {
  switch (node.kind) {
    case JsonKind::broken:
    case JsonKind::null:
      return "null";
    case JsonKind::flag:
      return node.flag ? "true" : "false";
    case JsonKind::integer:
    case JsonKind::real:
      return node.text.size() <= 30 ? node.text : fmt::format("{}", node.real);
    case JsonKind::text:
      return in_quotes(node.text);
    case JsonKind::list:
      return "a list";
    case JsonKind::object:
      return "an object";
  }
  return {};
}

}  // namespace moire
