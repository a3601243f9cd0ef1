// The kinds of pattern.
#pragma once

#include <memory>
#include <vector>

#include <moire/frame.h>

#include "look.h"
#include "tiles.h"

namespace pattern {

// Grey `mean` and the sum of these.
std::unique_ptr<moire::Frame> make_waves(const Look& look, double mean, std::vector<moire::Sinusoid> waves);

// mean + amplitude cos(a r^2), with a such that the larger of the frequencies along x and y reaches `peak_frequency`
// (cycles a pixel) at the middle of the longer side's ends.
std::unique_ptr<moire::Frame> make_zone_plate(const Look& look, double mean, double amplitude, double peak_frequency);

// exp(-r^2 / (2 sigma^2)), one in each tile.
std::unique_ptr<moire::Frame> make_blobs(const Look& look, double sigma);
std::unique_ptr<moire::Frame> make_tiled_blobs(const Look& look, double sigma, const Tiles& tiles);

// Light where the pattern's middle + `offset` is behind, in the direction of `angle_deg`.
struct EdgeAngle {
  double angle_deg;
  bool is_random;  // of each tile its own
};
std::unique_ptr<moire::Frame> make_edges(const Look& look, EdgeAngle angle, double offset, const Tiles& tiles);

std::unique_ptr<moire::Frame> make_disks(const Look& look, double radius, const Tiles& tiles);

// Light and dark stripes across the direction of `angle_deg`; `duty`: the part that is light, about phase 0.
struct Stripes {
  double frequency, angle_deg, phase_deg, duty;
};
std::unique_ptr<moire::Frame> make_grating(const Look& look, const Stripes& stripes);

std::unique_ptr<moire::Frame> make_checkerboard(const Look& look, double cell, double angle_deg);

// Siemens' star of `spokes` light wedges. Requires: spokes >= 2.
std::unique_ptr<moire::Frame> make_star(const Look& look, int spokes, double angle_deg);

}  // namespace pattern
