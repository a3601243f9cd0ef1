// Documents over the tree that experiments are read into, and its messages.
#include <moire/document.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <fmt/format.h>

#include <moire/error.h>
#include <moire/settings.h>

#include "files/whole_file.h"
#include "json/json_tree.h"
#include "json/nearest_name.h"

namespace moire {

namespace {

std::unique_ptr<const JsonNode> parsed(std::string_view text, std::string_view name) {
  Problems problems;
  auto tree = parse_json(text, std::make_shared<Source>(Source{std::string(name), {}}), "", problems);
  problems.throw_if_any();
  return std::make_unique<const JsonNode>(*std::move(tree));
}

std::span<const std::string_view> span_of(std::initializer_list<std::string_view> names) {
  return {names.begin(), names.size()};
}

// "a number from 0 to 10". An end that is infinite is no bound.
std::string number_between(double smallest, double largest) {
  if (std::isinf(smallest) && std::isinf(largest)) return "a number";
  if (std::isinf(largest)) return fmt::format("a number of {} or more", smallest);
  if (std::isinf(smallest)) return fmt::format("a number of {} or less", largest);
  return fmt::format("a number from {} to {}", smallest, largest);
}

[[noreturn]] void refuse_at(const Place& place, const std::string& path, std::string_view what) {
  throw Error(problem_at(place, path, what));
}

void require_object(const JsonNode& node, const std::string& path) {
  if (!node.is(JsonKind::object)) refuse_at(node.place, path, fmt::format("is {}; an object is expected", shown(node)));
}

}  // namespace

DocumentValue DocumentValue::operator[](std::string_view key) const {
  if (!has(key)) refuse(fmt::format("has no \"{}\"; it needs one", key));
  return {*node_->find(key), member_path(path_, key)};
}

bool DocumentValue::has(std::string_view key) const {
  require_object(*node_, path_);
  return node_->find(key) != nullptr;
}

void DocumentValue::allow_only(std::initializer_list<std::string_view> keys) const {
  require_object(*node_, path_);
  const auto known = span_of(keys);
  for (const JsonMember& member : node_->members) {
    if (std::find(keys.begin(), keys.end(), member.key) != keys.end()) continue;
    refuse_at(member.place, member_path(path_, member.key),
              fmt::format("unknown key{} known are {}", did_you_mean(member.key, known), listed(known)));
  }
}

std::size_t DocumentValue::size() const {
  if (!node_->is(JsonKind::list)) refuse(fmt::format("is {}; a list is expected", shown(*node_)));
  return node_->items.size();
}

DocumentValue DocumentValue::operator[](std::size_t index) const {
  if (index >= size()) {
    refuse(fmt::format("has {} item{}; it needs {} or more", size(), size() == 1 ? "" : "s", index + 1));
  }
  return {node_->items[index], item_path(path_, index)};
}

double DocumentValue::number(double smallest, double largest) const {
  if (!node_->is_number() || !(node_->real >= smallest && node_->real <= largest)) {
    refuse(fmt::format("is {}; {} is expected", shown(*node_), number_between(smallest, largest)));
  }
  return node_->real;
}

bool DocumentValue::flag() const {
  if (!node_->is(JsonKind::flag)) refuse(fmt::format("is {}; true or false is expected", shown(*node_)));
  return node_->flag;
}

const std::string& DocumentValue::text() const {
  if (!node_->is(JsonKind::text)) refuse(fmt::format("is {}; a text is expected", shown(*node_)));
  return node_->text;
}

std::size_t DocumentValue::choice(std::initializer_list<std::string_view> names) const {
  const auto known = span_of(names);
  const auto found = std::find(names.begin(), names.end(), node_->text);
  if (node_->is(JsonKind::text) && found != names.end()) return static_cast<std::size_t>(found - names.begin());
  const std::string hint = node_->is(JsonKind::text) ? did_you_mean(node_->text, known) : ";";
  refuse(fmt::format("is {}{} known are {}", shown(*node_), hint, listed(known)));
}

Color DocumentValue::color() const {
  if (node_->is(JsonKind::text)) {
    try {
      return parse_color(node_->text);
    } catch (const Error&) {  // does not know the place
    }
  }
  refuse(fmt::format("is {}; a colour such as \"#3fa0ff\" is expected", shown(*node_)));
}

void DocumentValue::refuse(std::string_view what) const { refuse_at(node_->place, path_, what); }

Document::Document(const std::filesystem::path& file) : root_(parsed(read_whole_file(file), file.string())) {}

Document::Document(std::string_view text, std::string_view name) : root_(parsed(text, name)) {}

Document::~Document() = default;

DocumentValue Document::root() const { return {*root_, ""}; }

}  // namespace moire
