// Convex pieces of a plane, cut by lines without allocating.
#pragma once

#include <cstddef>
#include <vector>

#include <moire/geometry.h>

#include "seeing/outline.h"

namespace shadow_planes {

// Corners first .. first + count - 1 of Pieces.
struct Piece {
  std::size_t first = 0, count = 0;
};

// A line, and below which value only rounding says that a point does not lie on it.
struct BorderLine {
  Line line;
  double tolerance = 0;
};

// Where a piece lies: all of it beyond the line (or on it), all of it within, or cut.
enum class Side { beyond, within, cut };

class Pieces {
 public:
  void clear() { used_ = 0; }
  const moire::Point& operator[](std::size_t corner) const { return corners_[corner]; }

  Piece add(const std::vector<moire::Point>& corners);
  Side side(Piece piece, const BorderLine& border) const;
  // Where a piece is cut it becomes the part within, and `beyond`, if asked for, the other. Points on the line belong
  // to both.
  Side divide(Piece& piece, const BorderLine& border, Piece* beyond);
  double doubled_area(Piece piece) const;

 private:
  // Where `count` more corners have room.
  std::size_t room(std::size_t count) {
    if (used_ + count > corners_.size()) corners_.resize(2 * (used_ + count));
    return used_;
  }

  std::vector<moire::Point> corners_;
  std::vector<double> values_;  // of a line, at the corners of a piece
  std::size_t used_ = 0;
};

inline Side Pieces::side(Piece piece, const BorderLine& border) const {
  bool some_within = false, some_beyond = false;
  for (std::size_t k = piece.first; k < piece.first + piece.count; ++k) {
    const double value = border.line(corners_[k]);
    some_within |= value > border.tolerance;
    some_beyond |= value < -border.tolerance;
  }
  if (!some_within) return Side::beyond;
  return some_beyond ? Side::cut : Side::within;
}

inline double Pieces::doubled_area(Piece piece) const {
  const moire::Point* p = corners_.data() + piece.first;
  double sum = 0;
  for (std::size_t k = 2; k < piece.count; ++k) {
    sum += (p[k - 1].x - p[0].x) * (p[k].y - p[0].y) - (p[k].x - p[0].x) * (p[k - 1].y - p[0].y);
  }
  return sum;
}

}  // namespace shadow_planes
