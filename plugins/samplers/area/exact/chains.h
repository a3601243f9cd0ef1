// The contours of layers cut into chains that run downward, and where among the rows they lie.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "exact/layers.h"
#include "exact/row_buckets.h"

namespace area {

// Points whose y does not fall. A level stretch encloses no area but it joins what lies left and right of it, so it
// stays in the chain that comes to it.
struct Chain {
  std::uint32_t first, last;  // points
  std::uint32_t layer;
  int direction;  // what it adds to the winding number on its right: 1 where the contour runs downward, else -1
};

// The chains of layers that reach the rows [0, rows) and lie left of `right`.
class Chains {
 public:
  Chains(const Layers& layers, int rows, double right);

  const moire::Point* points() const { return points_.data(); }
  std::size_t point_count() const { return points_.size(); }
  const Chain& operator[](std::uint32_t chain) const { return chains_[chain]; }

  // By the row in which they begin.
  const RowBuckets& buckets() const { return buckets_; }

 private:
  void cut(const moire::Point* points, const Layers::Contour& contour);
  void add(std::uint32_t first, std::uint32_t layer, int direction);

  int rows_;
  std::vector<moire::Point> points_;
  std::vector<Chain> chains_;
  RowBuckets buckets_;
};

}  // namespace area
