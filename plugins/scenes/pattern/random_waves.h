// Sinusoids of random frequencies that an image of one size can tell apart.
#pragma once

#include <cstdint>
#include <vector>

#include <moire/frame.h>

namespace pattern {

struct RandomWaves {
  int in_band, out_of_band;  // how many
  double rms;                // of their sum, over all places
  std::uint64_t seed;
};

// Frequencies (fx, fy) are whole multiples of 1 / width and 1 / height. Those in band have max(|fx|, |fy|) up to .45,
// those out of it .55 .. 3 cycles a pixel. No two fold to the same +-frequency in pixels, none to 0 or to Nyquist's
// along either axis. All have the same amplitude; phases are random. In band first. They depend on seed and size alone.
// Error: they find no place in so small an image.
std::vector<moire::Sinusoid> random_waves(const RandomWaves& wanted, moire::ImageSize size);

}  // namespace pattern
