// Drawings whose corners lie on a lattice, and what is seen of them, in whole numbers: without rounding.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "seeing/frame.h"

namespace moire::test {

struct Site {
  std::int64_t x = 0, y = 0;
};

struct LatticeLayer {
  FillRule rule = FillRule::nonzero;
  std::vector<std::vector<Site>> contours;
};

// Layers back to front, corners in steps of 1 / steps pixels.
struct LatticeDrawing {
  static constexpr std::int64_t steps = 8;
  std::vector<LatticeLayer> layers;

  // Layer k has element k + 1, and a colour of its own.
  cartoon::Drawing drawing() const;
};

// Layers of contours with corners anywhere in an image of this size and a little around it; every third corner lies on
// a coarser lattice, so that corners and edges meet.
LatticeDrawing random_drawing(int layers, int corners, ImageSize size, std::uint64_t seed);

// The element on top at a site of the lattice; nothing if it lies on an edge. By how often each contour goes around it:
// edges are counted that a line to the right meets.
std::optional<Element> seen_at(const LatticeDrawing& drawing, Site site);

// The drawing as it is, in an image of this size.
std::unique_ptr<Frame> frame_of(const cartoon::Drawing& drawing, ImageSize size);

// Each point in a batch of its own.
std::vector<Element> one_by_one(const Frame& frame, std::span<const SamplePoint> points);
std::vector<Element> together(const Frame& frame, std::span<const SamplePoint> points);

}  // namespace moire::test
