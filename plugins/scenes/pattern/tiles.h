// Squares of pixels, each with a pattern of its own, so that one image holds thousands of independent pixels.
#pragma once

#include <moire/random.h>

#include "look.h"

namespace pattern {

class Tiles {
 public:
  // `size` in pixels; 0: one tile, the whole plane.
  Tiles(const Look& look, int size, std::uint64_t seed) : look_(look), size_(size), seed_(seed) {}

  struct Tile {
    int i, j;
    moire::Point middle;  // of its pattern: within half a pixel of its own middle, each way; moved by the view
  };
  // Of pixel (x, y).
  Tile of(int x, int y) const {
    if (size_ == 0) return {0, 0, look_.middle()};
    const int i = floor_of(x), j = floor_of(y);
    const auto coordinate = [&](int index, double view, std::uint32_t dimension) {
      return (index + 0.5) * size_ + view + random(i, j, dimension) - 0.5;
    };
    return {i, j, {coordinate(i, look_.view.x, 0), coordinate(j, look_.view.y, 1)}};
  }
  Tile of(moire::Point p) const { return of(static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y))); }
  // In [0, 1), of a tile; dimensions 0 and 1 are its middle.
  double random(int i, int j, std::uint32_t dimension) const {
    return moire::random({.x = i, .y = j, .frame = 0, .seed = seed_}, 0, dimension);
  }

 private:
  int floor_of(int x) const { return x >= 0 ? x / size_ : -((-x - 1) / size_) - 1; }

  Look look_;
  int size_;
  std::uint64_t seed_;
};

}  // namespace pattern
