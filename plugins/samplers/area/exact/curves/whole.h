// Numbers of pixels.
#pragma once

#include <algorithm>

namespace area {

// What a number of columns or rows is at the most.
inline constexpr double far_off = 0x1p30;

inline int whole(double v) { return static_cast<int>(std::clamp(v, -far_off, far_off)); }

}  // namespace area
