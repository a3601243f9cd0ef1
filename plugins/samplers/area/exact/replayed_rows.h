// The pixels of some rows from boundaries in any order.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "exact/overlay.h"
#include "exact/row_buckets.h"
#include "exact/row_pixels.h"

namespace area {

template <bool recorded>
class ReplayedRows {
 public:
  // `cells`: empty, cells_of(width) for each row of a bucket; left empty again.
  ReplayedRows(const Layers& layers, int width, moire::PixelBlock& block, moire::Tally::Adder<recorded> add,
               std::span<PixelCell> cells)
      : layers_(layers), width_(width) {
    rows_.reserve(RowBuckets::rows_each);
    for (std::size_t k = 0; k < RowBuckets::rows_each; ++k)
      rows_.emplace_back(layers, width, block, add, cells.subspan(k * cells_of(width), cells_of(width)));
  }

  // The rows [first, end), no more than a bucket has.
  void begin(int first, int end) {
    first_ = first;
    end_ = end;
    for (int y = first; y < end; ++y) row(y).pixels.begin_row(y);
  }

  // A boundary that reaches some of the rows.
  void add(const Overlay::Boundary& b) {
    const Change change(layers_, b.left, b.right);
    const double slope = (b.lower.x - b.upper.x) / (b.lower.y - b.upper.y);
    int y = first_;
    double top = first_, x = b.upper.x;
    if (b.upper.y >= top) {
      top = b.upper.y;
      y = static_cast<int>(top);
    } else {
      x += (top - b.upper.y) * slope;
    }
    for (; y < end_; ++y) {
      const double bottom = y + 1;
      const bool goes_on = b.lower.y > bottom;
      const double next = goes_on ? b.upper.x + (bottom - b.upper.y) * slope : b.lower.x;
      Row& r = row(y);
      r.pixels.boundary(x, top - y, next, (goes_on ? bottom : b.lower.y) - y, change,
                        [&](int left, int right) { r.mark(left, right); });
      if (!goes_on) return;
      x = next;
      top = bottom;
    }
  }

  void deposit() {
    for (int y = first_; y < end_; ++y) {
      Row& r = row(y);
      content_.become(layers_, layers_.background());
      for (int pixel = 0; pixel < width_;) {
        const int begin = r.next(pixel, true, width_), end = r.next(begin, false, width_);
        r.pixels.deposit_solid(pixel, begin, content_);
        if (begin < end) r.pixels.deposit_crossed(begin, end, content_);
        pixel = end;
      }
      std::fill(r.crossed.begin(), r.crossed.end(), 0);
    }
  }

 private:
  struct Row {
    Row(const Layers& layers, int width, moire::PixelBlock& block, moire::Tally::Adder<recorded> add,
        std::span<PixelCell> cells)
        : pixels(layers, width, block, add, cells), crossed(static_cast<std::size_t>(width) / 64 + 1) {}

    void mark(int left, int right) {
      for (int pixel = left; pixel <= right; ++pixel)
        crossed[static_cast<std::size_t>(pixel) / 64] |= std::uint64_t{1} << (pixel % 64);
    }
    // The first pixel from this one on that boundaries cross, or that they do not.
    int next(int pixel, bool is_crossed, int width) const {
      while (pixel < width) {
        const std::uint64_t word = crossed[static_cast<std::size_t>(pixel) / 64];
        const std::uint64_t rest = (is_crossed ? word : ~word) >> (pixel % 64);
        if (rest != 0) return std::min(width, pixel + std::countr_zero(rest));
        pixel += 64 - pixel % 64;
      }
      return width;
    }

    RowPixels<recorded> pixels;
    std::vector<std::uint64_t> crossed;  // a bit a pixel
  };
  Row& row(int y) { return rows_[static_cast<std::size_t>(y % RowBuckets::rows_each)]; }

  const Layers& layers_;
  const int width_;
  int first_ = 0, end_ = 0;
  std::vector<Row> rows_;
  typename RowPixels<recorded>::Content content_{layers_, layers_.background()};
};

}  // namespace area
