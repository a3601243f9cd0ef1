// The pixels of a row from boundaries in any order.
#pragma once

#include <bit>
#include <vector>

#include "exact/overlay.h"
#include "exact/row_pixels.h"

namespace area {

template <bool recorded>
class ReplayedRow {
 public:
  explicit ReplayedRow(RowPixels<recorded>& pixels)
      : pixels_(pixels),
        content_(pixels.layers(), pixels.layers().background()),
        crossed_(static_cast<std::size_t>(pixels.width()) / 64 + 1) {}

  void begin_bucket() { active_.clear(); }

  // A boundary that reaches row y, and no row of the bucket before it that is deposited.
  void enter(const Overlay::Boundary& b, int y) {
    const double slope = (b.lower.x - b.upper.x) / (b.lower.y - b.upper.y);
    const double top = std::max(b.upper.y, static_cast<double>(y));
    const double x = top == b.upper.y ? b.upper.x : b.upper.x + (top - b.upper.y) * slope;
    active_.push_back({b.upper, b.lower, slope, x, top, Change(pixels_.layers(), b.left, b.right)});
  }

  void deposit(int y) {
    pixels_.begin_row(y);
    const double bottom = y + 1;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < active_.size(); ++k) {
      Active& a = active_[k];
      const bool goes_on = a.lower.y > bottom;
      const double end = goes_on ? bottom : a.lower.y;
      const double x = goes_on ? a.upper.x + (bottom - a.upper.y) * a.slope : a.lower.x;
      pixels_.boundary(a.x, a.y - y, x, end - y, a.change, [&](int first, int last) { mark(first, last); });
      if (!goes_on) continue;
      a.x = x;
      a.y = bottom;
      if (kept != k) active_[kept] = a;
      ++kept;
    }
    active_.erase(active_.begin() + static_cast<std::ptrdiff_t>(kept), active_.end());

    content_.become(pixels_.layers(), pixels_.layers().background());
    int pixel = 0;
    while (pixel < pixels_.width()) {
      const int begin = next(pixel, true), end = next(begin, false);
      pixels_.deposit_solid(pixel, begin, content_);
      if (begin < end) pixels_.deposit_crossed(begin, end, content_);
      pixel = end;
    }
    std::fill(crossed_.begin(), crossed_.end(), 0);
  }

 private:
  struct Active {
    moire::Point upper, lower;
    double slope, x, y;  // where it enters the next row
    Change change;
  };

  void mark(int first, int last) {
    for (int pixel = first; pixel <= last; ++pixel)
      crossed_[static_cast<std::size_t>(pixel) / 64] |= std::uint64_t{1} << (pixel % 64);
  }

  // The first pixel from this one on that boundaries cross, or that they do not.
  int next(int pixel, bool crossed) const {
    const int width = pixels_.width();
    while (pixel < width) {
      const std::uint64_t word = crossed_[static_cast<std::size_t>(pixel) / 64];
      const std::uint64_t rest = (crossed ? word : ~word) >> (pixel % 64);
      if (rest != 0) return std::min(width, pixel + std::countr_zero(rest));
      pixel += 64 - pixel % 64;
    }
    return width;
  }

  RowPixels<recorded>& pixels_;
  typename RowPixels<recorded>::Content content_;
  std::vector<Active> active_;          // in the order of the overlay, so that sums do not depend on where they begin
  std::vector<std::uint64_t> crossed_;  // a bit a pixel
};

}  // namespace area
