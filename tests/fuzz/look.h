// Looks at a drawing that a reader made of anything at all.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>

#include <moire/error.h>

#include "drawing/bounds.h"
#include "seeing/frame.h"

namespace moire::fuzz {

// Flattens it for a small image, and asks for points and lines. Whatever the drawing, nothing may go wrong.
inline void look_at(const cartoon::Drawing& drawing) {
  const std::optional<cartoon::Box> box = cartoon::bounds_of(drawing);
  if (!box) return;
  const double extent = std::max({box->width, box->height, 1e-9}), scale = 16 / extent;
  auto outlines = std::make_shared<const cartoon::Outlines>(drawing, extent / 100, Blend::linear);
  const Affine placement{scale, 0, -box->x * scale, 0, scale, -box->y * scale};
  const cartoon::CartoonFrame frame(std::move(outlines), placement, {16, 16}, {}, Blend::linear);
  SamplePoint points[16];
  Hit hits[16];
  Counters counters;
  for (int k = 0; k < 16; ++k) points[k] = {8.5, 15.5 - k};
  frame.trace(points, hits, counters);
  for (int k = 0; k < 16; ++k) points[k] = {k + 0.25 * (k % 4), 3.0 * k};
  frame.trace(points, hits, counters);
  const double cuts[] = {0, 3, 9};
  const ImageLine lines[] = {{{8, 12}, {8, 3}, cuts}, {{1, 12}, {10, 12}, cuts}, {{1, 2}, {3, 14}, cuts}};
  Tally pieces(6, true);
  frame.lines()->along(lines, nullptr, pieces);
  for (std::size_t slot = 0; slot < 6; ++slot) {
    if (!(std::abs(pieces.weight(slot) - (cuts[slot % 2 + 1] - cuts[slot % 2])) < 1e-9)) __builtin_trap();
  }
}

}  // namespace moire::fuzz
