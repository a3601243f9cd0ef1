// The colours of error maps: one definition for the pictures that a run writes and for the scale that a report shows.
#include "report/error_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace moire::report {
namespace {

constexpr Color not_a_number{0, 1, 0};

// Lightness 0 (black) to 1 (white); a from green to red, b from blue to yellow.
struct Oklab {
  double lightness, a, b;
};

// Evenly spaced, straight in between. Chosen here: lightness in equal steps, hue from violet over red to yellow, every
// point inside sRGB.
constexpr std::array<Oklab, 6> absolute_path = {{{0.00, 0, 0},
                                                 {0.19, 0.045, -0.090},
                                                 {0.38, 0.120, -0.075},
                                                 {0.57, 0.160, 0.040},
                                                 {0.76, 0.060, 0.120},
                                                 {0.95, -0.005, 0.060}}};
constexpr std::array<Oklab, 3> below_zero_path = {{{1, 0, 0}, {0.72, -0.045, -0.090}, {0.44, -0.020, -0.180}}};
constexpr std::array<Oklab, 3> above_zero_path = {{{1, 0, 0}, {0.72, 0.105, 0.065}, {0.44, 0.150, 0.080}}};

Oklab along(std::span<const Oklab> path, double t) {
  const double place = t * static_cast<double>(path.size() - 1);
  const auto first = std::min(static_cast<std::size_t>(place), path.size() - 2);
  const double f = place - static_cast<double>(first);
  const Oklab &p = path[first], &q = path[first + 1];
  return {p.lightness + f * (q.lightness - p.lightness), p.a + f * (q.a - p.a), p.b + f * (q.b - p.b)};
}

// The matrices of Ottosson's page.
Color linear_light(const Oklab& c) {
  const double l = std::pow(c.lightness + 0.3963377774 * c.a + 0.2158037573 * c.b, 3);
  const double m = std::pow(c.lightness - 0.1055613458 * c.a - 0.0638541728 * c.b, 3);
  const double s = std::pow(c.lightness - 0.0894841775 * c.a - 1.2914855480 * c.b, 3);
  const auto in_gamut = [](double light) { return static_cast<float>(std::clamp(light, 0.0, 1.0)); };
  return {in_gamut(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          in_gamut(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          in_gamut(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

}  // namespace

Color absolute_error_color(double value, double scale) {
  if (std::isnan(value)) return not_a_number;
  return linear_light(along(absolute_path, std::clamp(value / scale, 0.0, 1.0)));
}

Color signed_error_color(double value, double scale) {
  if (std::isnan(value)) return not_a_number;
  const double t = std::min(std::abs(value) / scale, 1.0);
  return linear_light(value < 0 ? along(below_zero_path, t) : along(above_zero_path, t));
}

std::string css_color(Color color) {
  return fmt::format("#{:02x}{:02x}{:02x}", srgb_code(color.r), srgb_code(color.g), srgb_code(color.b));
}

}  // namespace moire::report
