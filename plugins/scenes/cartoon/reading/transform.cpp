#include "transform.h"

#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include <fmt/format.h>

#include <moire/error.h>
#include <moire/turn.h>

#include "drawing/drawing.h"
#include "numbers.h"

namespace cartoon {

namespace {

using moire::Affine;

double tangent(double degrees) {
  const moire::Turn turning = moire::turn_of(degrees);
  return turning.sine / turning.cosine;
}

struct Function {
  std::string_view name;
  std::array<std::size_t, 3> counts;  // of numbers that it may take; 0: none
  std::string_view arguments;
  Affine (*map)(std::span<const double>);
};

constexpr Function functions[] = {
    {"matrix",
     {6, 0, 0},
     "a b c d e f",
     [](std::span<const double> a) { return Affine{a[0], a[2], a[4], a[1], a[3], a[5]}; }},
    {"translate",
     {1, 2, 0},
     "tx, or tx ty",
     [](std::span<const double> a) { return Affine{.x0 = a[0], .y0 = a.size() > 1 ? a[1] : 0}; }},
    {"scale", {1, 2, 0}, "s, or sx sy", [](std::span<const double> a) { return Affine{.xx = a[0], .yy = a.back()}; }},
    {"rotate",
     {1, 3, 0},
     "angle, or angle cx cy",
     [](std::span<const double> a) {
       const moire::Turn t = moire::turn_of(a[0]);
       const Affine turn{t.cosine, -t.sine, 0, t.sine, t.cosine, 0};
       if (a.size() == 1) return turn;
       return then(then(Affine{.x0 = -a[1], .y0 = -a[2]}, turn), Affine{.x0 = a[1], .y0 = a[2]});
     }},
    {"skewX", {1, 0, 0}, "angle", [](std::span<const double> a) { return Affine{.xy = tangent(a[0])}; }},
    {"skewY", {1, 0, 0}, "angle", [](std::span<const double> a) { return Affine{.yx = tangent(a[0])}; }},
};

const Function& find_function(std::string_view name) {
  for (const Function& function : functions) {
    if (function.name == name) return function;
  }
  throw moire::Error(fmt::format("has the function {}; known are matrix, translate, scale, rotate, skewX and skewY",
                                 shown_front(name)));
}

// The numbers up to the closing bracket.
std::array<double, 6> read_arguments(Numbers& numbers, const Function& function, std::size_t& count) {
  std::array<double, 6> values{};
  const auto takes = [&](std::size_t n) {
    return n > 0 && (n == function.counts[0] || n == function.counts[1] || n == function.counts[2]);
  };
  for (count = 0; numbers.skip_space(), numbers.peek() != ')'; ++count) {
    if (count > 0) numbers.skip_separator();
    const std::string_view rest = numbers.rest();
    const std::optional<double> value = numbers.number();
    if (!value || count == values.size()) {
      throw moire::Error(
          fmt::format("has {} in \"{}\"; it takes {}", shown_front(rest), function.name, function.arguments));
    }
    if (!(std::abs(*value) <= largest_coordinate)) {
      throw moire::Error(fmt::format("has the number {:.6g} in \"{}\"; at most {:g} can be drawn", *value,
                                     function.name, largest_coordinate));
    }
    values[count] = *value;
  }
  numbers.advance();
  if (!takes(count)) {
    throw moire::Error(fmt::format("has {} numbers in \"{}\"; it takes {}", count, function.name, function.arguments));
  }
  return values;
}

}  // namespace

Affine parse_transform(std::string_view text) {
  Numbers numbers(text);
  Affine all;
  numbers.skip_space();
  if (trimmed(text) == "none") return all;
  while (!numbers.at_end()) {
    const std::string_view rest = numbers.rest();
    const std::size_t bracket = rest.find('(');
    const Function& function = find_function(trimmed(rest.substr(0, std::min(bracket, rest.size()))));
    if (bracket == rest.npos) throw moire::Error(fmt::format("has no bracket after \"{}\"", function.name));
    for (std::size_t k = 0; k <= bracket; ++k) numbers.advance();
    std::size_t count = 0;
    const std::array<double, 6> values = read_arguments(numbers, function, count);
    all = then(function.map(std::span(values).first(count)), all);
    numbers.skip_separator();
  }
  const double determinant = all.determinant();
  if (!std::isfinite(determinant) || determinant == 0) {
    throw moire::Error(
        fmt::format("cannot be inverted (its determinant is {:g}); nothing would be left of the drawing", determinant));
  }
  return all;
}

}  // namespace cartoon
