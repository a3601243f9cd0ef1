// The numbers of SVG, read from the front of a text.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace cartoon {

class Numbers {
 public:
  explicit Numbers(std::string_view text) : text_(text) {}

  // The next number with a sign, a fraction and an exponent if it has them, as far as it goes ("1.5.5-3e2" is three);
  // nothing if there is none. Larger than double goes: infinite.
  std::optional<double> number();
  // One character, 0 or 1, as the flags of arcs.
  std::optional<bool> flag();

  void skip_space();
  // White space and at most one comma.
  void skip_separator();

  bool at_end() const { return at_ == text_.size(); }
  char peek() const { return at_end() ? '\0' : text_[at_]; }
  void advance() { ++at_; }
  std::size_t position() const { return at_; }
  std::string_view rest() const { return text_.substr(at_); }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

bool is_space(char c);
std::string_view trimmed(std::string_view text);

// What stands at the front of a text, in quotes, for messages: a few characters, or `the end`.
std::string shown_front(std::string_view text);

}  // namespace cartoon
