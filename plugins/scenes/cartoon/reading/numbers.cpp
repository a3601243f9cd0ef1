#include "numbers.h"

#include <charconv>
#include <cstdlib>
#include <string>

namespace cartoon {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

std::string shown_front(std::string_view text) {
  if (text.empty()) return "the end";
  constexpr std::size_t longest = 12;
  std::string shown = "\"";
  for (const char c : text.substr(0, longest)) shown += c >= ' ' && c <= '~' ? c : '?';
  return shown + (text.size() > longest ? "...\"" : "\"");
}

void Numbers::skip_space() {
  while (!at_end() && is_space(text_[at_])) ++at_;
}

void Numbers::skip_separator() {
  skip_space();
  if (peek() == ',') {
    ++at_;
    skip_space();
  }
}

std::optional<bool> Numbers::flag() {
  if (peek() != '0' && peek() != '1') return std::nullopt;
  return text_[at_++] == '1';
}

std::optional<double> Numbers::number() {
  std::size_t end = at_;
  const auto digits = [&] {
    const std::size_t first = end;
    while (end < text_.size() && is_digit(text_[end])) ++end;
    return end > first;
  };
  const auto is = [&](char c) { return end < text_.size() && text_[end] == c; };
  if (is('+') || is('-')) ++end;
  bool has_digits = digits();
  if (is('.')) {
    ++end;
    has_digits = digits() || has_digits;
  }
  if (!has_digits) return std::nullopt;
  if (is('e') || is('E')) {
    const std::size_t before = end++;
    if (is('+') || is('-')) ++end;
    if (!digits()) end = before;  // as in "2em"
  }

  const std::string_view written = text_.substr(at_, end - at_);
  const std::string_view unsigned_part = written.substr(written.front() == '+' ? 1 : 0);
  double value = 0;
  const auto [stop, error] = std::from_chars(unsigned_part.data(), unsigned_part.data() + unsigned_part.size(), value);
  // Beyond the range of double from_chars does not say at which end.
  if (error == std::errc::result_out_of_range) value = std::strtod(std::string(written).c_str(), nullptr);
  at_ = end;
  return value;
}

}  // namespace cartoon
