// A sink of Rows that deposits pixels. Where no boundary is near, a pixel has the colour of one layer, to the bit.
#pragma once

#include "exact/row_pixels.h"

namespace area {

template <bool recorded>
class SweptRow {
 public:
  explicit SweptRow(RowPixels<recorded>& pixels)
      : pixels_(pixels), content_(pixels.layers(), pixels.layers().background()) {}

  void begin_row(int y) {
    pixels_.begin_row(y);
    begin_ = end_ = 0;
    content_.become(pixels_.layers(), pixels_.layers().background());
  }
  void open(double left, std::uint32_t front) {
    const int pixel = left <= 0 ? 0 : static_cast<int>(left);
    if (pixel < end_) return;
    go_to(pixel, front);
  }
  void boundary(double x0, double y0, double x1, double y1, std::uint32_t left, std::uint32_t right, std::uint32_t) {
    pixels_.boundary(x0, y0, x1, y1, Change(pixels_.layers(), left, right), [](int, int) {});
  }
  void close(double right) {
    if (right > 0) end_ = std::max(end_, right >= pixels_.width() ? pixels_.width() : static_cast<int>(right) + 1);
  }
  void end_row(std::uint32_t front) { go_to(pixels_.width(), front); }

 private:
  // Deposits the pixels that boundaries cross and, up to `pixel`, those that `front` fills.
  void go_to(int pixel, std::uint32_t front) {
    pixels_.deposit_crossed(begin_, end_, content_);
    content_.become(pixels_.layers(), front);
    pixels_.deposit_solid(end_, pixel, content_);
    begin_ = end_ = pixel;
  }

  RowPixels<recorded>& pixels_;
  typename RowPixels<recorded>::Content content_;  // left of begin_
  int begin_ = 0, end_ = 0;                        // pixels that boundaries cross, not yet deposited
};

}  // namespace area
