#include "summits.h"

#include <algorithm>
#include <limits>

#include <moire/texture.h>

#include "voxels.h"

namespace heightfield {

namespace {

// From an index to the end of its block.
int to_block_end(int index, int period) { return std::min(Summits::block - index % Summits::block, period - index); }

}  // namespace

Summits::Summits(const std::vector<Cell>& cells, int width, int height)
    : width_(2 * width), height_(2 * height), blocks_((width_ + block - 1) / block) {
  const int rows = (height_ + block - 1) / block;
  highest_.assign(static_cast<std::size_t>(blocks_ * rows), std::numeric_limits<float>::lowest());
  for (int j = 0; j < height_; ++j) {
    const auto row = static_cast<std::size_t>(moire::wrapped(j, height, moire::Wrap::mirror) * width);
    for (int i = 0; i < width_; ++i) {
      const auto column = static_cast<std::size_t>(moire::wrapped(i, width, moire::Wrap::mirror));
      float& highest = highest_[static_cast<std::size_t>(j / block * blocks_ + i / block)];
      highest = std::max(highest, cells[row + column].height);
    }
  }
}

int Summits::length(bool swapped, int p) const { return to_block_end(p, swapped ? height_ : width_); }

float Summits::highest(const Run& run) const {
  const int period = run.swapped ? width_ : height_;
  float highest = std::numeric_limits<float>::lowest();
  int q = run.q;
  for (int left = run.aside; left >= 0;) {
    const int row = run.swapped ? run.p : q, column = run.swapped ? q : run.p;
    highest = std::max(highest, highest_[static_cast<std::size_t>(row / block * blocks_ + column / block)]);
    const int rest = to_block_end(q, period);
    left -= rest;
    q += rest;
    if (q == period) q = 0;
  }
  return highest;
}

}  // namespace heightfield
