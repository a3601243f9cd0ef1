// What is left of convex outlines where others lie over them.
#pragma once

#include <algorithm>
#include <vector>

#include "seeing/outline.h"
#include "world/cut.h"

namespace shadow_planes {

// Whether an edge of one lies between it and all of the other.
inline bool are_apart(const Outline& one, const Outline& other) {
  const moire::Point* from = &one.back();
  for (const moire::Point& to : one) {
    const Line edge = edge_line(*from, to);
    if (std::none_of(other.begin(), other.end(), [&](const moire::Point& p) { return edge(p) > 0; })) return true;
    from = &to;
  }
  return false;
}

// Appends what `cover` leaves of `piece` to `left`, in convex pieces, edge by edge; leaves in `piece` what it covers.
// Pieces of no more than this doubled area are dropped. The last two are space to work in.
inline void cut_out(Outline& piece, const Outline& cover, double least, std::vector<Outline>& left, Outline& inside,
                    Outline& outside) {
  const moire::Point* from = &cover.back();
  for (const moire::Point& to : cover) {
    split(piece, edge_line(*from, to), inside, outside);
    from = &to;
    if (doubled_area(outside) > least) left.push_back(outside);
    std::swap(piece, inside);
    if (!(doubled_area(piece) > least)) return;
  }
}

}  // namespace shadow_planes
