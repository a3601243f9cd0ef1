// Colours: linear-light RGB, and the sRGB curve that files and screens use (IEC 61966-2-1).
#pragma once

#include <algorithm>
#include <cmath>

namespace moire {

// Linear light; 0 is black, 1 the brightest white of an 8-bit image.
struct Color {
  float r = 0, g = 0, b = 0;

  friend bool operator==(const Color&, const Color&) = default;
  friend Color operator+(Color p, Color q) { return {p.r + q.r, p.g + q.g, p.b + q.b}; }
  friend Color operator-(Color p, Color q) { return {p.r - q.r, p.g - q.g, p.b - q.b}; }
  friend Color operator*(float f, Color c) { return {f * c.r, f * c.g, f * c.b}; }
};

// One channel, sRGB code value in 0..1 to linear light. Values outside continue the curve's ends.
inline double srgb_to_linear(double code) {
  return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

// The inverse of srgb_to_linear.
inline double linear_to_srgb(double light) {
  return light <= 0.0031308 ? light * 12.92 : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

// The 8-bit code value that a screen shows, 0 .. 255. Requires: a number.
inline int srgb_code(float light) {
  return static_cast<int>(std::lround(255 * linear_to_srgb(std::clamp(light, 0.0F, 1.0F))));
}

}  // namespace moire
