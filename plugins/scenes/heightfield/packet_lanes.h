// What the code for each kind of vector is given: lines that share rows, octant and direction.
#pragma once

#include <cstdint>
#include <span>

#include <moire/tally.h>

#include "look.h"
#include "packet.h"

namespace heightfield {

struct PacketLine {
  std::size_t index = 0;       // in the batch
  std::size_t first_slot = 0;  // in the tally
  Direction start{};           // of the ray at the line's begin
  Direction plane_ray{};       // any ray of the line's plane, where one plane holds the whole line
  bool one_plane = false;
  bool fits = true;  // found out while its rows are prepared
};

struct PacketTask {
  const View& view;
  Plane octant;                  // m does not count
  Direction step;                // how the ray changes with a pixel along the line
  std::span<const double> cuts;  // of every line
  moire::Color sky;
  Interpolation interpolation;
};

// Follows the lines, but for those that it finds not to fit.
void follow(const PacketTask& task, std::span<PacketLine> lines, moire::Tally& pieces);

}  // namespace heightfield
