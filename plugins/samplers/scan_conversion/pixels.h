// Pixels by their number, and numbers wide enough to count them.
//
// Pixel (x, y) is the one whose middle lies at (x + 0.5, y + 0.5) of the image. What draws here hands each pixel that
// it lights to `put(x, y, intensity)`, no pixel twice: a functor, so that samplers, tests and benchmarks share one
// loop.
#pragma once

#include <cmath>
#include <cstdint>

#include <moire/geometry.h>
#include <moire/tally.h>

namespace scan_conversion {

// Products of a pixel's number and a fraction of 64 bits.
__extension__ using Wide = unsigned __int128;
__extension__ using SignedWide = __int128;

struct PixelIndex {
  std::int64_t x = 0, y = 0;
  friend bool operator==(const PixelIndex&, const PixelIndex&) = default;
};

// Numbers of pixels stay within this: farther away the last place of a double is no small part of a pixel.
inline constexpr double farthest = 0x1p40;

inline std::int64_t whole(double x) { return static_cast<std::int64_t>(std::floor(x)); }

// The pixel that holds the point. Requires: |x|, |y| <= farthest.
inline PixelIndex pixel_of(moire::Point p) { return {whole(p.x), whole(p.y)}; }

inline bool holds(const moire::PixelArea& area, std::int64_t x, std::int64_t y) {
  return x >= area.x0 && y >= area.y0 && x < area.x0 + area.width && y < area.y0 + area.height;
}

// Hands on what lies inside.
template <class Put>
struct Clipped {
  const moire::PixelArea& area;
  Put& put;

  template <class Number>
  void operator()(Number x, Number y, std::uint32_t intensity) const {
    if (holds(area, x, y)) put(static_cast<int>(x), static_cast<int>(y), intensity);
  }
};
template <class Put>
Clipped(const moire::PixelArea&, Put&) -> Clipped<Put>;

}  // namespace scan_conversion
