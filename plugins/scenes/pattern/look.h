// What all kinds of pattern share: where their middle is, their two colours, their elements, directions.
#pragma once

#include <cstdint>

#include <moire/color.h>
#include <moire/element.h>
#include <moire/geometry.h>
#include <moire/turn.h>

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

// The unit vector `degrees` clockwise of the x axis.
inline moire::Point direction(double degrees) {
  const moire::Turn turn = moire::turn_of(degrees);
  return {turn.cosine, turn.sine};
}

constexpr double dot(moire::Point p, moire::Point q) { return p.x * q.x + p.y * q.y; }
constexpr double cross(moire::Point p, moire::Point q) { return p.x * q.y - p.y * q.x; }
constexpr moire::Point operator+(moire::Point p, moire::Point q) { return {p.x + q.x, p.y + q.y}; }
constexpr moire::Point operator-(moire::Point p, moire::Point q) { return {p.x - q.x, p.y - q.y}; }
constexpr moire::Point operator*(double f, moire::Point p) { return {f * p.x, f * p.y}; }
constexpr moire::Point middle_of(int x, int y) { return {x + 0.5, y + 0.5}; }

}  // namespace pattern
