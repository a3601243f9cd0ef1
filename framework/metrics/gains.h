// How much of each sinusoid of a known pattern a picture shows.
#pragma once

#include <complex>
#include <span>
#include <vector>

#include <moire/frame.h>

#include "metrics/picture.h"

namespace moire {

// In the band that a picture can hold: max(|fx|, |fy|) below half a cycle a pixel.
bool is_in_band(const Sinusoid& wave);

// Where a frequency of cycles a pixel appears in a row of pixels, in [-1/2, 1/2): the whole cycles between two pixels
// are not seen.
double folded(double frequency);

// The complex gain of each component a cos(2 pi f.x + phi) at the bin to which it folds:
//   T = 2 / (a P) sum over the P pixels m of I[m] exp(-i (2 pi f.(m + 1/2) + phi)),
// I the mean of the channels, in linear light. 1 at full height and in place, 0 where nothing is left of it.
// Empty if the components cannot be told apart: frequencies that are no multiples of 1 / width and 1 / height, that
// fold to the same bin or its mirror, or to constants or half a cycle a pixel.
std::vector<std::complex<double>> gains(const Picture& picture, std::span<const Sinusoid> waves);

}  // namespace moire
