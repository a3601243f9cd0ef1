// The eight mirrored octants of a circle about a pixel's middle: pixels (i, j), 0 <= j <= i, of the first one and their
// distinct images.
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "../pixels.h"

namespace scan_conversion {

struct PixelCircle {
  PixelIndex center;
  std::int64_t radius = 0;  // 0 .. farthest

  // Rows 0 .. last_row() of the first octant lie below its diagonal: floor(radius / sqrt(2)).
  std::int64_t last_row() const;
};

inline std::int64_t PixelCircle::last_row() const {
  const SignedWide square = SignedWide{radius} * radius;
  auto row = static_cast<std::int64_t>(static_cast<double>(radius) * 0x1.6a09e667f3bcdp-1);
  while (2 * SignedWide{row} * row > square) --row;
  while (2 * SignedWide{row + 1} * (row + 1) <= square) ++row;
  return row;
}

// Every distinct mirror image of the pixel once. Requires: 0 <= j <= i.
template <class Number, class Put>
void put_images(Number x, Number y, Number i, Number j, std::uint32_t intensity, Put& put) {
  if (j != 0 && i != j) {
    put(x + i, y + j, intensity);
    put(x - i, y + j, intensity);
    put(x + i, y - j, intensity);
    put(x - i, y - j, intensity);
    put(x + j, y + i, intensity);
    put(x - j, y + i, intensity);
    put(x + j, y - i, intensity);
    put(x - j, y - i, intensity);
  } else if (j != 0) {
    put(x + i, y + j, intensity);
    put(x - i, y + j, intensity);
    put(x + i, y - j, intensity);
    put(x - i, y - j, intensity);
  } else if (i != 0) {
    put(x + i, y, intensity);
    put(x - i, y, intensity);
    put(x, y + i, intensity);
    put(x, y - i, intensity);
  } else {
    put(x, y, intensity);
  }
}

struct Rows {
  std::int64_t first = 0, end = 0;
};

// Offsets v >= 0 at which a circle about 0 may run within low <= u <= high, with some to spare.
Rows offsets_between(double radius, double low, double high);

// Rows 0 .. last of the first octant that may have an image in the area, as ranges in rising order, each row once.
class VisibleRows {
 public:
  VisibleRows(const PixelCircle& circle, std::int64_t last, const moire::PixelArea& area);

  std::span<const Rows> ranges() const { return {ranges_.data(), count_}; }

 private:
  std::array<Rows, 8> ranges_;
  std::size_t count_ = 0;
};

// Calls draw(rows, x, y, put) for the visible ones of rows 0 .. last: (x, y) is the centre in numbers that hold all
// pixels handed to `put`. `margin`: pixels outside the circle that it may light.
template <class Put, class Draw>
void for_visible_rows(const PixelCircle& circle, std::int64_t last, int margin, const moire::PixelArea& area, Put& put,
                      Draw draw) {
  const std::int64_t reach = circle.radius + margin;
  const auto [x, y] = circle.center;
  if (holds(area, x - reach, y - reach) && holds(area, x + reach, y + reach)) {
    return draw(Rows{0, last + 1}, static_cast<int>(x), static_cast<int>(y), put);
  }
  const Clipped clipped{area, put};
  const VisibleRows visible(circle, last, area);
  for (const Rows rows : visible.ranges()) draw(rows, x, y, clipped);
}

}  // namespace scan_conversion
