// What is in front along straight lines of the image.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cells.h"

namespace primitives {

// Along part of a line one shape is in front.
struct Run {
  static constexpr std::uint32_t nothing = 0xffffffffU;

  double begin, end;    // distances from the line's beginning, in pixels
  std::uint32_t shape;  // its place, or `nothing`
};

class Runs {
 public:
  // Both outlive this.
  Runs(std::span<const Shape> shapes, const Cells& cells) : shapes_(shapes), cells_(cells), seen_(shapes.size(), 0) {}

  // From `begin` to `end`, one after another, no two of one shape side by side. Valid until the next call.
  // Requires: from != to, begin < end.
  std::span<const Run> along(moire::Point from, moire::Point to, double begin, double end);

 private:
  void meet_shapes(const Ray& ray, double begin, double end);

  std::span<const Shape> shapes_;
  const Cells& cells_;
  std::vector<std::uint32_t> seen_;  // the line that last met each shape
  std::uint32_t line_ = 0;
  std::vector<Run> met_, open_, runs_;  // of each shape alone; a heap of those that the place is in; of the front
};

}  // namespace primitives
