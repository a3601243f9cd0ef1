// The pixel's own square, in closed forms that lose nothing at any angle or size: areas within [-1/2, 1/2]^2.
#pragma once

#include <moire/geometry.h>

namespace pattern {

class Square {
 public:
  static constexpr bool is_positive = true;  // weights are areas
  // Whether what a part is found to weigh is rounding: it only touches the pixel.
  static constexpr bool is_nothing(double weight) { return weight < 0x1p-50; }

  static constexpr double radius() { return 0.5; }
  static double below(double x) { return x <= -0.5 ? 0 : x >= 0.5 ? 1 : x + 0.5; }
  // As those of Window.
  static double along(moire::Point p, moire::Point q);
  static double half_plane(double a, double b, double s) {
    // The distance, times |(a, b)|, by which the corner that lies farthest in is in.
    const double in = s + (a + b) / 2;
    if (in <= 0) return 0;
    if (in >= a + b) return 1;
    if (a < b) return half_plane(b, a, s);
    if (in < b) return in / a * (in / b) / 2;
    const double out = a + b - in;
    return out < b ? 1 - out / a * (out / b) / 2 : (in - b / 2) / a;
  }
  static double disk(moire::Point middle, double radius);
};

}  // namespace pattern
