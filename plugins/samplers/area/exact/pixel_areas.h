// The area of a polygon in each pixel that it touches, exact but for rounding.
//
// Each edge leaves in its row of pixels the area between itself and the row's right end (signed: edges that fall in y
// take it away again): the sum over all edges is the polygon's. Pixels are visited from the polygon's left end, or the
// picture's, so that what a pixel gets does not depend on which pixels are asked for.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <moire/frame.h>

namespace area {

class PixelAreas {
 public:
  explicit PixelAreas(moire::PixelArea window) : window_(window) {}

  // Calls deposit(x, y, area) for every pixel of the window of which the polygon takes up more than rounding errors (of
  // one that lies in a single pixel: than nothing), the same to the bit whatever the window is. Contours
  // do not cross; holes are turned against their outline. Pixels left of column 0 are no part of the picture.
  template <class Deposit>
  void of(const moire::Polygon& polygon, Deposit deposit);

 private:
  // From a to b, both in the rows of the store.
  void edge(moire::Point a, moire::Point b);
  // The part of an edge within one row of pixels.
  void in_row(double* row, moire::Point a, moire::Point b);
  // The part of it within one pixel.
  static void in_pixel(double* pixel, double left, double dy, double middle) {
    const double right_of = left + 1 - middle;
    pixel[0] += dy * right_of;
    pixel[1] += dy * (1 - right_of);
  }

  moire::PixelArea window_;
  int x0_ = 0, y0_ = 0, width_ = 0, height_ = 0;  // the pixels of the store
  std::vector<double> store_;                     // rows with two places more than pixels
};

template <class Deposit>
void PixelAreas::of(const moire::Polygon& polygon, Deposit deposit) {
  const std::span<const moire::Point> points = polygon.points;
  double left = points[0].x, right = left, top = points[0].y, bottom = top;
  for (const moire::Point p : points) {
    left = std::min(left, p.x), right = std::max(right, p.x);
    top = std::min(top, p.y), bottom = std::max(bottom, p.y);
  }
  const int window_x1 = window_.x0 + window_.width, window_y1 = window_.y0 + window_.height;
  if (!(right > window_.x0 && left < window_x1 && bottom > window_.y0 && top < window_y1)) return;

  // Relative to one corner, so that slivers keep their digits.
  double doubled = 0;
  const auto contours = polygon.contours;
  for (std::size_t c = 0; c < contours.size(); ++c) {
    const std::size_t first = contours[c], end = c + 1 < contours.size() ? contours[c + 1] : points.size();
    const moire::Point origin = points[first];
    for (std::size_t k = first + 1; k + 1 < end; ++k) {
      doubled += (points[k].x - origin.x) * (points[k + 1].y - origin.y) -
                 (points[k + 1].x - origin.x) * (points[k].y - origin.y);
    }
  }
  const double pixel_x = std::floor(left), pixel_y = std::floor(top);
  if (right <= pixel_x + 1 && bottom <= pixel_y + 1) {
    if (doubled != 0) deposit(static_cast<int>(pixel_x), static_cast<int>(pixel_y), std::abs(doubled) / 2);
    return;
  }

  x0_ = static_cast<int>(std::max(pixel_x, 0.0));
  y0_ = static_cast<int>(std::max(pixel_y, static_cast<double>(window_.y0)));
  width_ = static_cast<int>(std::min(std::ceil(right), static_cast<double>(window_x1))) - x0_;
  height_ = static_cast<int>(std::min(std::ceil(bottom), static_cast<double>(window_y1))) - y0_;
  if (width_ <= 0 || height_ <= 0) return;
  const auto pitch = static_cast<std::size_t>(width_) + 2;
  store_.assign(pitch * static_cast<std::size_t>(height_), 0.0);
  for (std::size_t c = 0; c < contours.size(); ++c) {
    const std::size_t first = contours[c], end = c + 1 < contours.size() ? contours[c + 1] : points.size();
    for (std::size_t k = first; k + 1 < end; ++k) edge(points[k], points[k + 1]);
    edge(points[end - 1], points[first]);
  }
  // An edge that rises in y, seen with y downward, has the area at its right side where the polygon is turned so.
  const double turn = doubled < 0 ? 1 : -1;
  // Pixels that the polygon does not touch are left with the rounding errors of the edges beside them.
  const double least = 0x1p-50 * static_cast<double>(points.size());
  for (int j = 0; j < height_; ++j) {
    const double* row = store_.data() + pitch * static_cast<std::size_t>(j);
    double sum = 0;
    for (int i = 0; i < width_; ++i) {
      sum += row[i];
      const double area = turn * sum;
      if (area > least && x0_ + i >= window_.x0) deposit(x0_ + i, y0_ + j, area);
    }
  }
}

}  // namespace area
