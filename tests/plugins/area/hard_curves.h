// Pixels that are hard to integrate: lines and circles made so that boundaries meet in one of them.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "support/curve_frame.h"

namespace moire::test {

struct HardCurves {
  int x, y;                   // the pixel
  std::vector<Curve> curves;  // back to front; elements count from 1
};

// What is hard about them.
std::span<const std::string_view> hard_curve_kinds();

// The same for the same kind and seed. Requires: kind is one of hard_curve_kinds().
HardCurves hard_curves(std::string_view kind, std::uint64_t seed);

}  // namespace moire::test
