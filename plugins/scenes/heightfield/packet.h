// Upright image lines followed side by side, a column a lane of the machine's vectors (Highway chooses them at run
// time). Every lane does the arithmetic of Look::stretches, operation by operation, so it deposits the same bits:
// whichever lines come together, however many lanes there are.
#pragma once

#include <span>
#include <vector>

#include <moire/frame.h>

#include "look.h"

namespace heightfield {

// Whether packets can follow lines of this look at all: one voxel a step, going on from row to row, from above all
// summits, and finite colours, since a voxel that is not seen counts with weight 0. Seen from above only the far edge
// of a box counts, and no terrain is seen above the horizon.
bool packets_fit(const Look& look);

// Lookups that packets know.
enum class Interpolation { nearest, linear_across };

// Follows those lines that fit and marks them: upright, of the same rows as the first, looking up along the line, all
// in one octant. Line k's stretches are the slots from first_slots[k] on. Requires: packets_fit(look); `pieces` does
// not record.
void follow_in_packets(const Look& look, moire::Color sky, Interpolation interpolation,
                       std::span<const moire::ImageLine> lines, std::span<const std::size_t> first_slots,
                       moire::Tally& pieces, std::vector<bool>& followed);

// How many lines side by side the vectors of this machine hold.
std::size_t lanes_of_packets();

}  // namespace heightfield
