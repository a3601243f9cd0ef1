// Segments of the image and the pixels that they cross.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <moire/tally.h>

#include "pixels/critical_lines.h"
#include "seeing/camera.h"
#include "seeing/outline.h"

namespace shadow_planes {

struct ImageSegment {
  moire::Point from, to;
  Line line;  // its value is the distance in pixels
};

class SegmentIndex {
 public:
  struct Cell {
    int x;
    std::uint32_t segment;
  };

  // What a camera sees of lines, in a picture of this size, which may be larger than the camera's.
  SegmentIndex(const std::vector<CriticalLine>& lines, const Camera& camera, moire::ImageSize size);

  // In the order of segments(); those of a pixel side by side. Some may only touch it.
  std::span<const Cell> in_pixel(int x, int y) const;
  bool any_in(const moire::PixelArea& area) const;

  const ImageSegment& operator[](std::uint32_t segment) const { return segments_[segment]; }

 private:
  void enter(std::uint32_t segment);

  moire::ImageSize size_;
  std::vector<ImageSegment> segments_;
  std::vector<std::vector<Cell>> rows_;
};

}  // namespace shadow_planes
