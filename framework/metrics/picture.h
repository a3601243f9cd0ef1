// A finished image, and its comparison with another.
#pragma once

#include <span>
#include <vector>

#include <moire/color.h>
#include <moire/geometry.h>
#include <moire/tally.h>

namespace moire {

// Row 0 the top, rows follow each other; linear light.
struct Picture {
  ImageSize size;
  std::vector<Color> pixels;
};

// Copies a block's colours into their place. Requires: the block lies in the picture.
void put(const PixelBlock& block, Picture& picture);

// Colour values are compared in linear light or as sRGB code values, in levels: 1/255 of full scale.
enum class Space { linear, srgb };
inline constexpr double levels_of_full_scale = 255;

// value - reference of each channel of each pixel, in levels. Requires: pictures of one size.
std::vector<double> differences(const Picture& picture, const Picture& reference, Space space);

// Root of the mean square of all differences.
double root_mean_square(std::span<const double> differences);

}  // namespace moire
