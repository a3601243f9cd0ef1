// The part of a picture that is worth magnifying.
#pragma once

#include <array>
#include <span>

#include <moire/geometry.h>

namespace moire {

// x, y, width, height of the square of `side` pixels (less where the image is smaller) whose sum of `error` is
// greatest; the first such in reading order. What is not finite counts as 0. Requires: error.size() == width * height
// of `size`, row 0 the top; side > 0.
std::array<int, 4> worst_window(std::span<const double> error, ImageSize size, int side = 48);

// The same square in the middle of the image.
std::array<int, 4> middle_window(ImageSize size, int side = 48);

}  // namespace moire
