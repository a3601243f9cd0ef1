#include "shapes.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include <moire/error.h>

#include "numbers.h"
#include "path_data.h"

namespace cartoon {

namespace {

using moire::Error;

struct Unit {
  std::string_view name;
  double user_units;
};
// CSS Values and Units Level 3, section 5.2: an inch is 96 user units.
constexpr Unit units[] = {{"", 1},           {"px", 1},         {"in", 96},      {"cm", 96 / 2.54},
                          {"mm", 96 / 25.4}, {"pt", 96.0 / 72}, {"pc", 96.0 / 6}};

// An attribute's length in user units; nothing if it is not there or "auto".
std::optional<double> length(const pugi::xml_node& element, const char* attribute) {
  const std::string_view text = trimmed(element.attribute(attribute).value());
  if (text.empty() || text == "auto") return std::nullopt;
  Numbers numbers(text);
  const std::optional<double> number = numbers.number();
  const auto unit = std::ranges::find(units, numbers.rest(), &Unit::name);
  if (!number || unit == std::end(units)) {
    throw Error(fmt::format("{} is {}; a length is a number, or one with px, in, cm, mm, pt or pc", attribute,
                            shown_front(text)));
  }
  const double value = *number * unit->user_units;
  if (!(std::abs(value) <= largest_coordinate)) {
    throw Error(fmt::format("{} is {}; at most {:g} can be drawn", attribute, shown_front(text), largest_coordinate));
  }
  return value;
}

double place(const pugi::xml_node& element, const char* attribute) { return length(element, attribute).value_or(0); }

std::optional<double> size(const pugi::xml_node& element, const char* attribute) {
  const std::optional<double> value = length(element, attribute);
  if (value && *value < 0) throw Error(fmt::format("{} is {:g}; a size is at least 0", attribute, *value));
  return value;
}

void draw_rectangle(const pugi::xml_node& element, Pen& pen) {
  const double x0 = place(element, "x"), y0 = place(element, "y");
  const double width = size(element, "width").value_or(0), height = size(element, "height").value_or(0);
  if (width == 0 || height == 0) return;
  const double x1 = x0 + width, y1 = y0 + height;
  const std::optional<double> wanted_rx = size(element, "rx"), wanted_ry = size(element, "ry");
  const double rx = std::min(wanted_rx.value_or(wanted_ry.value_or(0)), width / 2);
  const double ry = std::min(wanted_ry.value_or(wanted_rx.value_or(0)), height / 2);
  if (rx == 0 || ry == 0) {
    pen.move_to({x0, y0});
    pen.line_to({x1, y0});
    pen.line_to({x1, y1});
    pen.line_to({x0, y1});
  } else {
    pen.move_to({x0 + rx, y0});
    pen.line_to({x1 - rx, y0});
    pen.arc_to(rx, ry, 0, false, true, {x1, y0 + ry});
    pen.line_to({x1, y1 - ry});
    pen.arc_to(rx, ry, 0, false, true, {x1 - rx, y1});
    pen.line_to({x0 + rx, y1});
    pen.arc_to(rx, ry, 0, false, true, {x0, y1 - ry});
    pen.line_to({x0, y0 + ry});
    pen.arc_to(rx, ry, 0, false, true, {x0 + rx, y0});
  }
  pen.close();
}

void draw_ellipse(const pugi::xml_node& element, Pen& pen, std::optional<double> rx, std::optional<double> ry) {
  const double across = rx.value_or(ry.value_or(0)), down = ry.value_or(rx.value_or(0));
  if (across == 0 || down == 0) return;
  pen.ellipse({place(element, "cx"), place(element, "cy")}, across, down);
}

void draw_points(std::string_view text, Pen& pen) {
  Numbers numbers(text);
  double x = 0;
  std::size_t count = 0;
  for (numbers.skip_space(); !numbers.at_end(); numbers.skip_separator(), ++count) {
    const std::optional<double> value = numbers.number();
    if (!value) {
      throw Error(fmt::format("points, character {}: has {}; x and y take turns", numbers.position() + 1,
                              shown_front(numbers.rest())));
    }
    if (count % 2 == 0) {
      x = *value;
    } else {
      count == 1 ? pen.move_to({x, *value}) : pen.line_to({x, *value});
    }
  }
  if (count % 2 == 1) throw Error(fmt::format("points has {} numbers; x and y take turns", count));
  pen.close();
}

}  // namespace

bool draw_shape(std::string_view name, const pugi::xml_node& element, Pen& pen) {
  if (name == "path") {
    try {
      draw_path_data(element.attribute("d").value(), pen);
    } catch (const Error& error) {
      throw Error(fmt::format("d, {}", error.what()));
    }
  } else if (name == "rect") {
    draw_rectangle(element, pen);
  } else if (name == "circle") {
    const std::optional<double> r = size(element, "r");
    draw_ellipse(element, pen, r, r);
  } else if (name == "ellipse") {
    draw_ellipse(element, pen, size(element, "rx"), size(element, "ry"));
  } else if (name == "polygon" || name == "polyline") {
    draw_points(element.attribute("points").value(), pen);
  } else {
    return false;
  }
  return true;
}

}  // namespace cartoon
