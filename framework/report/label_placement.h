// Where to write labels beside points so that they neither overlap each other nor hide what is drawn.
#pragma once

#include <span>
#include <vector>

#include <moire/geometry.h>

namespace moire::report {

struct LabelWish {
  Point point;   // what it belongs to
  double width;  // of its text
};

struct PlacedLabel {
  Rectangle box;
  bool needs_leader = false;  // it lies so far from its point that a line should join them
};

// Greedy: each label takes the place around its point that costs least, those before it staying where they are.
// Covering a label costs most, then a point, then an obstacle; then distance.
std::vector<PlacedLabel> place_labels(std::span<const LabelWish> wishes, double height, const Rectangle& bounds,
                                      std::span<const Rectangle> obstacles);

}  // namespace moire::report
