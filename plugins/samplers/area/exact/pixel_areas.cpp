#include "exact/pixel_areas.h"

namespace area {

void PixelAreas::edge(moire::Point a, moire::Point b) {
  if (a.y == b.y) return;
  const double low = y0_, high = y0_ + height_;
  const bool down = a.y < b.y;
  const moire::Point upper = down ? a : b, lower = down ? b : a;
  if (lower.y <= low || upper.y >= high) return;
  const auto pitch = static_cast<std::size_t>(width_) + 2;
  const auto row_at = [&](double row_top) { return store_.data() + pitch * static_cast<std::size_t>(row_top - low); };
  double row_top = std::floor(std::max(upper.y, low));
  if (upper.y >= low && lower.y <= row_top + 1) return in_row(row_at(row_top), a, b);

  // x where the edge crosses the border between two rows of pixels.
  const double slope = (lower.x - upper.x) / (lower.y - upper.y);
  const auto x_at = [&](double y) {
    return std::clamp(upper.x + (y - upper.y) * slope, std::min(a.x, b.x), std::max(a.x, b.x));
  };
  moire::Point at = upper;
  if (upper.y < low) at = {x_at(low), low};
  for (; at.y < lower.y && row_top < high; ++row_top) {
    const double border = row_top + 1;
    const moire::Point next = lower.y <= border ? lower : moire::Point{x_at(border), border};
    double* row = row_at(row_top);
    down ? in_row(row, at, next) : in_row(row, next, at);
    at = next;
  }
}

void PixelAreas::in_row(double* row, moire::Point a, moire::Point b) {
  const double left = x0_, right = x0_ + width_;
  const double dy = b.y - a.y;
  const double first = std::floor(std::min(a.x, b.x)), last = std::max(a.x, b.x);
  if (last <= first + 1 && first >= left && first < right) {
    in_pixel(row + static_cast<int>(first - left), first, dy, (a.x + b.x) / 2);
    return;
  }
  if (last <= left) {
    row[0] += dy;
    return;
  }
  if (first >= right) return;

  // From pixel to pixel, with y where the edge crosses their borders.
  const bool forth = a.x < b.x;
  const moire::Point begin = forth ? a : b, end = forth ? b : a;
  const double slope = (end.y - begin.y) / (end.x - begin.x), turn = forth ? 1 : -1;
  moire::Point at = begin;
  if (begin.x < left) {
    at = {left, begin.y + (left - begin.x) * slope};
    row[0] += turn * (at.y - begin.y);
  }
  for (double pixel = std::floor(at.x); at.x < end.x && pixel < right; ++pixel) {
    const moire::Point next =
        end.x <= pixel + 1 ? end : moire::Point{pixel + 1, begin.y + (pixel + 1 - begin.x) * slope};
    in_pixel(row + static_cast<int>(pixel - left), pixel, turn * (next.y - at.y), (at.x + next.x) / 2);
    at = next;
  }
}

}  // namespace area
