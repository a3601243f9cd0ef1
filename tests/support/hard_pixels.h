// Pixels that are hard to integrate: drawings made so that vertices, edges and layers meet in one of them.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "support/polygon_frame.h"

namespace moire::test {

struct HardPixel {
  std::string_view kind;
  ImageSize size;
  int x, y;                           // the pixel
  std::vector<FlatPolygon> polygons;  // front to back; elements count from 1

  // The largest of 1 and all corners' coordinates.
  double largest_coordinate() const;
};

// What is hard about them.
std::span<const std::string_view> hard_pixel_kinds();

// The same for the same kind and seed, with one compiler and mathematical library. Requires: kind is one of
// hard_pixel_kinds().
HardPixel hard_pixel(std::string_view kind, std::uint64_t seed);

}  // namespace moire::test
