#include "path_data.h"

#include <array>

#include <fmt/format.h>

#include <moire/error.h>

#include "numbers.h"

namespace cartoon {

namespace {

using moire::Point;

// What a command takes each time, as SVG names it.
std::string_view arguments_of(char command) {
  switch (command | 0x20) {
    case 'm':
    case 'l':
    case 't':
      return "x y";
    case 'h':
      return "x";
    case 'v':
      return "y";
    case 'c':
      return "x1 y1 x2 y2 x y";
    case 's':
      return "x2 y2 x y";
    case 'q':
      return "x1 y1 x y";
    case 'a':
      return "rx ry angle large-arc-flag sweep-flag x y";
    default:
      return "";
  }
}

constexpr std::string_view commands = "MmLlHhVvCcSsQqTtAaZz";

int count_of(char command) {
  constexpr std::string_view letters = "mlthvcsqa";
  constexpr std::array counts{2, 2, 2, 1, 1, 6, 4, 4, 7};
  const auto found = letters.find(static_cast<char>(command | 0x20));
  return found == letters.npos ? 0 : counts[found];
}

class Reader {
 public:
  Reader(std::string_view data, Pen& pen) : numbers_(data), pen_(pen) {}

  void read() {
    numbers_.skip_space();
    for (bool first = true; !numbers_.at_end(); first = false) {
      const char command = numbers_.peek();
      position_ = numbers_.position();
      if (commands.find(command) == commands.npos) {
        fail(
            fmt::format("has {} where a command is expected; commands are {}", shown_front(numbers_.rest()), commands));
      }
      if (first && (command | 0x20) != 'm') {
        fail(fmt::format("begins with \"{}\"; path data begins with \"M\" or \"m\"", command));
      }
      numbers_.advance();
      numbers_.skip_space();
      follow(command);
    }
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw moire::Error(fmt::format("character {}: {}", position_ + 1, what));
  }

  // One command with all its repetitions.
  void follow(char command) {
    if ((command | 0x20) == 'z') {
      pen_.close();
      previous_ = 'z';
      return;
    }
    do {
      read_arguments(command);
      draw(command);
      previous_ = static_cast<char>(command | 0x20);
      // Further pairs after a move are lines.
      if (command == 'M') command = 'L';
      if (command == 'm') command = 'l';
      numbers_.skip_space();
      position_ = numbers_.position();
      if (numbers_.peek() == ',') {
        numbers_.skip_separator();
        if (!begins_number()) fail("has a comma that no number follows; remove the comma");
      }
    } while (begins_number());
  }

  bool begins_number() const {
    const char c = numbers_.peek();
    return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+';
  }

  void read_arguments(char command) {
    const int count = count_of(command);
    for (int k = 0; k < count; ++k) {
      if (k > 0) numbers_.skip_separator();
      const std::size_t at = numbers_.position();
      const bool is_flag = count == 7 && (k == 3 || k == 4);
      const std::optional<double> value = is_flag ? as_number(numbers_.flag()) : numbers_.number();
      if (!value) {
        position_ = at;
        fail(fmt::format("\"{}\" has {} of {} numbers (then {}{}); it takes {}", command, k, count,
                         shown_front(numbers_.rest()), is_flag ? ", no flag" : "", arguments_of(command)));
      }
      arguments_[static_cast<std::size_t>(k)] = *value;
    }
  }
  static std::optional<double> as_number(std::optional<bool> flag) {
    return flag ? std::optional<double>(*flag ? 1 : 0) : std::nullopt;
  }

  void draw(char command) {
    try {
      draw_checked(command);
    } catch (const moire::Error& error) {
      fail(fmt::format("\"{}\" {}", command, error.what()));
    }
  }

  void draw_checked(char command) {
    const auto& a = arguments_;
    const Point from = pen_.at(), base = command >= 'a' ? from : Point{};
    const auto point = [&](std::size_t k) { return Point{base.x + a[k], base.y + a[k + 1]}; };
    const auto reflected = [&] { return Point{2 * from.x - control_.x, 2 * from.y - control_.y}; };
    switch (command | 0x20) {
      case 'm':
        return pen_.move_to(point(0));
      case 'l':
        return pen_.line_to(point(0));
      case 'h':
        return pen_.line_to({base.x + a[0], from.y});
      case 'v':
        return pen_.line_to({from.x, base.y + a[0]});
      case 'c':
        control_ = point(2);
        return pen_.cubic_to(point(0), control_, point(4));
      case 's': {
        const Point first = previous_ == 'c' || previous_ == 's' ? reflected() : from;
        control_ = point(0);
        return pen_.cubic_to(first, control_, point(2));
      }
      case 'q':
        control_ = point(0);
        return pen_.quadratic_to(control_, point(2));
      case 't':
        control_ = previous_ == 'q' || previous_ == 't' ? reflected() : from;
        return pen_.quadratic_to(control_, point(0));
      default:
        return pen_.arc_to(a[0], a[1], a[2], a[3] != 0, a[4] != 0, point(5));
    }
  }

  Numbers numbers_;
  Pen& pen_;
  std::size_t position_ = 0;  // of what is read now, from 0
  char previous_ = '\0';      // the command before, in lower case
  std::array<double, 7> arguments_{};
  Point control_;  // of the curve before: what S and T reflect
};

}  // namespace

void draw_path_data(std::string_view data, Pen& pen) { Reader(data, pen).read(); }

}  // namespace cartoon
