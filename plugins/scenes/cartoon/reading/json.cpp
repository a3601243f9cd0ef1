#include "json.h"

#include <iterator>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <moire/error.h>

#include "drawing/pen.h"
#include "numbers.h"
#include "paint.h"

namespace cartoon {

namespace {

using moire::Error;

// Hands characters to the parser and counts lines. The parser looks one character ahead after a number.
class LineCounter {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  LineCounter(const char* at, std::size_t* line) : at_(at), line_(line) {}

  reference operator*() const { return *at_; }
  LineCounter& operator++() {
    *line_ += *at_++ == '\n' ? 1 : 0;
    return *this;
  }
  friend bool operator==(const LineCounter& a, const LineCounter& b) { return a.at_ == b.at_; }

 private:
  const char* at_;
  std::size_t* line_;
};

// What is open, the outermost first.
enum class Within { file, drawing, view_box, layers, layer, contours, contour, point };

class Builder final : public nlohmann::json_sax<nlohmann::json> {
 public:
  Builder(std::string_view text, std::string_view name) : text_(text), name_(name), pen_(drawing_) {}

  Drawing build() {
    const LineCounter first(text_.data(), &line_), last(text_.data() + text_.size(), &line_);
    nlohmann::json::sax_parse(first, last, this);
    if (!has_layers_) fail("", "has no \"layers\"; a drawing is {\"layers\": [...]}");
    return std::move(drawing_);
  }

  bool null() override { return wrong("null"); }
  bool boolean(bool value) override { return wrong(value ? "true" : "false"); }
  bool number_integer(number_integer_t value) override { return number(static_cast<double>(value)); }
  bool number_unsigned(number_unsigned_t value) override { return number(static_cast<double>(value)); }
  bool number_float(number_float_t value, const string_t&) override { return number(value); }
  bool binary(binary_t&) override { return false; }  // never called: JSON has none

  bool string(string_t& value) override {
    if (within_ == Within::drawing && key_ == "background") {
      drawing_.background = color(value);
    } else if (within_ == Within::layer && key_ == "color") {
      color_ = color(value);
    } else if (within_ == Within::layer && key_ == "rule") {
      if (value != "nonzero" && value != "evenodd") {
        fail(path(), fmt::format("is {}; known are nonzero and evenodd", shown_front(value)));
      }
      rule_ = value == "evenodd" ? moire::FillRule::even_odd : moire::FillRule::nonzero;
    } else {
      return wrong(shown_front(value));
    }
    return true;
  }

  bool start_object(std::size_t) override {
    if (within_ == Within::file) {
      within_ = Within::drawing;
    } else if (within_ == Within::layers) {
      within_ = Within::layer;
      rule_ = moire::FillRule::nonzero;
      has_color_ = has_rule_ = has_contours_ = false;
    } else {
      return wrong("an object");
    }
    key_.clear();
    return true;
  }

  bool end_object() override {
    if (within_ == Within::drawing) {
      within_ = Within::file;
      return true;
    }
    key_.clear();
    if (!has_color_ || !has_contours_) {
      fail(path(), fmt::format("has no \"{}\"; a layer has a color and contours", has_color_ ? "contours" : "color"));
    }
    pen_.finish(color_, rule_);
    within_ = Within::layers;
    ++layer_;
    return true;
  }

  bool start_array(std::size_t) override {
    if (within_ == Within::drawing && key_ == "layers") {
      within_ = Within::layers;
    } else if (within_ == Within::drawing && key_ == "view_box") {
      within_ = Within::view_box;
      numbers_ = 0;
    } else if (within_ == Within::layer && key_ == "contours") {
      within_ = Within::contours;
      contour_ = 0;
    } else if (within_ == Within::contours) {
      within_ = Within::contour;
      point_ = 0;
    } else if (within_ == Within::contour) {
      within_ = Within::point;
      numbers_ = 0;
    } else {
      return wrong("a list");
    }
    return true;
  }

  bool end_array() override {
    switch (within_) {
      case Within::point:
        if (numbers_ != 2) fail(path(), fmt::format("has {} numbers; a point is [x, y]", numbers_));
        draw_point();
        ++point_;
        within_ = Within::contour;
        break;
      case Within::contour:
        pen_.close();
        ++contour_;
        within_ = Within::contours;
        break;
      case Within::contours:
        within_ = Within::layer;
        break;
      case Within::view_box:
        if (numbers_ != 4) fail(path(), fmt::format("has {} numbers; it is [x, y, width, height]", numbers_));
        drawing_.view_box = {values_[0], values_[1], values_[2], values_[3]};
        within_ = Within::drawing;
        break;
      default:
        within_ = Within::drawing;
        break;
    }
    return true;
  }

  bool key(string_t& value) override {
    const bool in_layer = within_ == Within::layer;
    key_.clear();
    bool* const seen =
        in_layer ? find_key(value, "color", has_color_, "rule", has_rule_, "contours", has_contours_)
                 : find_key(value, "layers", has_layers_, "background", has_background_, "view_box", has_view_box_);
    if (!seen) {
      fail(path(), fmt::format("has the key {}; known are {}", shown_front(value),
                               in_layer ? "color, rule and contours" : "layers, background and view_box"));
    }
    key_ = value;
    if (*seen) fail(path(), "stands there twice; keep one of them");
    *seen = true;
    return true;
  }

  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception& error) override {
    std::string_view what = error.what();
    if (const auto dash = what.find(" - "); dash != what.npos) what.remove_prefix(dash + 3);
    what = what.substr(0, what.find("; last read"));
    if (const auto bracket = what.find("] "); what.starts_with("[json.") && bracket != what.npos) {
      what.remove_prefix(bracket + 2);
    }
    fail("", fmt::format("is not JSON: {}", what));
  }

 private:
  static bool* find_key(std::string_view key, std::string_view a, bool& has_a, std::string_view b, bool& has_b,
                        std::string_view c, bool& has_c) {
    return key == a ? &has_a : key == b ? &has_b : key == c ? &has_c : nullptr;
  }

  // Where the reader is: `layers[2].contours[0][5]`.
  std::string path() const {
    switch (within_) {
      case Within::file:
        return "";
      case Within::drawing:
        return key_;
      case Within::view_box:
        return "view_box";
      case Within::layers:
        return fmt::format("layers[{}]", layer_);
      case Within::layer:
        return fmt::format("layers[{}]{}{}", layer_, key_.empty() ? "" : ".", key_);
      case Within::contours:
        return fmt::format("layers[{}].contours[{}]", layer_, contour_);
      default:
        return fmt::format("layers[{}].contours[{}][{}]", layer_, contour_, point_);
    }
  }

  [[noreturn]] void fail(const std::string& at, std::string_view what) const {
    throw Error(fmt::format("{}:{}: {}{}{}", name_, line_, at, at.empty() ? "" : ": ", what));
  }

  std::string_view expected() const {
    switch (within_) {
      case Within::file:
        return "a drawing is {\"layers\": [...]}";
      case Within::drawing:
        return key_ == "layers"     ? "it is a list"
               : key_ == "view_box" ? "it is [x, y, width, height]"
                                    : "it is \"#rrggbb\"";
      case Within::layers:
        return "a layer is {\"color\": \"#rrggbb\", \"contours\": [...]}";
      case Within::layer:
        return key_ == "contours" ? "it is a list"
               : key_ == "rule"   ? "known are nonzero and evenodd"
                                  : "it is \"#rrggbb\"";
      case Within::contours:
        return "a contour is a list of points";
      default:
        return within_ == Within::contour ? "a point is [x, y]" : "numbers are expected";
    }
  }
  [[noreturn]] bool wrong(std::string_view found) const { fail(path(), fmt::format("is {}; {}", found, expected())); }

  Rgb color(const std::string& value) const {
    try {
      return parse_hex(value);
    } catch (const Error& error) {
      fail(path(), error.what());
    }
  }

  bool number(double value) {
    const std::size_t most = within_ == Within::point ? 2 : within_ == Within::view_box ? 4 : 0;
    if (most == 0) wrong(fmt::format("{}", value));
    if (numbers_ < most) values_[numbers_] = value;
    ++numbers_;
    return true;
  }

  void draw_point() {
    const moire::Point p{values_[0], values_[1]};
    try {
      point_ == 0 ? pen_.move_to(p) : pen_.line_to(p);
    } catch (const Error& error) {
      fail(path(), error.what());
    }
  }

  std::string_view text_, name_;
  std::size_t line_ = 1;
  Drawing drawing_;
  Pen pen_;
  Within within_ = Within::file;
  std::string key_;                                  // of the object that is open
  std::size_t layer_ = 0, contour_ = 0, point_ = 0;  // which is open, or comes next
  double values_[4] = {};                            // of a point or the view box
  std::size_t numbers_ = 0;                          // how many of them there were
  bool has_layers_ = false, has_background_ = false, has_view_box_ = false;
  // Of the layer that is open.
  Rgb color_;
  moire::FillRule rule_ = moire::FillRule::nonzero;
  bool has_color_ = false, has_rule_ = false, has_contours_ = false;
};

}  // namespace

Drawing read_json(std::string_view text, std::string_view name) { return Builder(text, name).build(); }

}  // namespace cartoon
