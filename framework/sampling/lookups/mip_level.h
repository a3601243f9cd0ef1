// How coarse a level of a pyramid is wanted.
#pragma once

namespace moire {

// The binary logarithm of the square root of `squared`, the level whose texels are so long, plus `bias`, in 0 .. top; 0
// of all lengths up to one texel before the bias. What is infinite or not a number gives `top`: a footprint that nobody
// knows is averaged over everything. Off by less than 1e-7, with the same bits on every machine, which the C library
// does not promise of its logarithms.
double mip_level(double squared, double bias, int top);

}  // namespace moire
