// Power spectra of pictures.
#pragma once

#include <span>
#include <vector>

#include <moire/geometry.h>

namespace moire {

// |transform|^2 / P at each bin of a picture of P values, row 0 the top: white noise of variance s^2 has s^2
// everywhere. Bin (u, v) is the frequency u / width, v / height, those above a half the negative ones.
std::vector<double> power_spectrum(std::span<const double> values, ImageSize size);

// The mean power on rings of equal width, the last one ending at half a cycle a pixel: points of frequency (a ring's
// middle, cycles a pixel) and power. Without the constant, and without rings that hold no bin.
std::vector<Point> radial_mean(std::span<const double> power, ImageSize size, int rings);

}  // namespace moire
