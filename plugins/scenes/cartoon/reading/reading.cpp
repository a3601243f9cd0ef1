#include "reading.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include <moire/error.h>

#include "drawing/bounds.h"
#include "json.h"
#include "numbers.h"

namespace cartoon {

namespace {

using moire::Error;

constexpr std::uintmax_t largest_file = std::uintmax_t{1} << 30;
// Of a view box: smaller ones would make images of drawings reach beyond the range of numbers.
constexpr double smallest_side = 1e-9;

// With a view box that can be shown.
void complete(Drawing& drawing, std::string_view name) {
  const std::optional<Box> bounds = bounds_of(drawing);
  if (!bounds) throw Error(fmt::format("{}: is an empty drawing; at least one filled shape is needed", name));
  const bool is_given = drawing.view_box.has_value();
  if (!is_given) drawing.view_box = bounds;
  const auto [x, y, width, height] = *drawing.view_box;
  const bool is_fine = std::min(width, height) >= smallest_side &&
                       std::max({std::abs(x), std::abs(y), width, height}) <= 2 * largest_coordinate;
  if (is_fine) return;
  throw Error(
      fmt::format("{}: {} is {:g} x {:g} at ({:g}, {:g}); its sides are {:g} to {:g}, as far from the origin at most",
                  name, is_given ? "the view box" : "the box around all that is drawn", width, height, x, y,
                  smallest_side, 2 * largest_coordinate));
}

}  // namespace

Drawing read_drawing(std::string_view text, std::string_view name, Unmodelled unmodelled) {
  if (text.starts_with("\x1f\x8b")) {
    throw Error(fmt::format("{}: is compressed; unpack it first (gunzip -S .svgz)", name));
  }
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) {
    throw Error(fmt::format("{}: is UTF-16; save it as UTF-8", name));
  }
  std::string_view front = text;
  if (front.starts_with("\xef\xbb\xbf")) front.remove_prefix(3);
  front = trimmed(front);
  if (!front.starts_with('<') && !front.starts_with('{')) {
    throw Error(fmt::format("{}: begins with {}; an SVG drawing begins with \"<\", a JSON one with \"{{\"", name,
                            shown_front(front)));
  }
  Drawing drawing = front.front() == '<' ? read_svg(text, name, unmodelled) : read_json(text, name);
  complete(drawing, name);
  return drawing;
}

Drawing read_drawing_file(const std::string& file, Unmodelled unmodelled) {
  std::error_code problem;
  const std::uintmax_t size = std::filesystem::file_size(file, problem);
  if (!problem && size > largest_file) {
    throw Error(fmt::format("{}: is too large ({} bytes); at most {} can be read", file, size, largest_file));
  }
  std::string text(problem ? 0 : size, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (problem || !stream) {
    throw Error(fmt::format("{}: cannot be read ({}); a readable file is needed", file,
                            problem ? problem.message() : "an input error"));
  }
  return read_drawing(text, file, unmodelled);
}

}  // namespace cartoon
