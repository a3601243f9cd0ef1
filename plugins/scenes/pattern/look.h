// What all kinds of pattern share: where their middle is, their two colours, their elements, directions.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include <moire/color.h>
#include <moire/element.h>
#include <moire/geometry.h>

namespace pattern {

// Part (i, j) of a pattern: a cell, a stripe, what is light in a tile. Never the background.
constexpr moire::Element part(std::int64_t i, std::int64_t j = 0) { return moire::texel_element(0, i, j); }

// Greys between two colours: 0 is dark, 1 is light, and others continue the line.
struct Greys {
  moire::Color dark, light;

  moire::Color mix(double grey) const {
    const auto channel = [grey](float from, float to) {
      return static_cast<float>(from + grey * (static_cast<double>(to) - from));
    };
    return {channel(dark.r, light.r), channel(dark.g, light.g), channel(dark.b, light.b)};
  }
  moire::Color of(bool is_light) const { return is_light ? light : dark; }
};

struct Look {
  moire::ImageSize size;
  moire::Point view;  // by how much everything is moved
  Greys greys;

  // Where patterns have their origin.
  moire::Point middle() const { return {0.5 * size.width + view.x, 0.5 * size.height + view.y}; }
};

// The unit vector `degrees` clockwise of the x axis: exact at multiples of 90, equal components at odd ones of 45.
inline moire::Point direction(double degrees) {
  const double turned = std::remainder(degrees, 360);
  const double quarters = std::nearbyint(turned / 90), rest = turned - 90 * quarters;
  const double angle = rest * (std::numbers::pi / 180), c = std::cos(angle);
  const double s = std::abs(rest) == 45 ? std::copysign(c, rest) : std::sin(angle);
  switch ((static_cast<int>(quarters) + 4) % 4) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

constexpr double dot(moire::Point p, moire::Point q) { return p.x * q.x + p.y * q.y; }
constexpr double cross(moire::Point p, moire::Point q) { return p.x * q.y - p.y * q.x; }
constexpr moire::Point operator+(moire::Point p, moire::Point q) { return {p.x + q.x, p.y + q.y}; }
constexpr moire::Point operator-(moire::Point p, moire::Point q) { return {p.x - q.x, p.y - q.y}; }
constexpr moire::Point operator*(double f, moire::Point p) { return {f * p.x, f * p.y}; }
constexpr moire::Point middle_of(int x, int y) { return {x + 0.5, y + 0.5}; }

}  // namespace pattern
