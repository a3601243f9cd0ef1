// Where a texture coordinate lies between the middles of two texels.
#pragma once

#include <cmath>
#include <cstdint>

namespace moire {

// The texels are `first` and first + 1, with weights 1 - fraction and fraction. (Cohen-Or 1997, eq. 4, prints ceil(y) -
// y and y - floor(y), which are both zero at whole y.)
struct Between {
  std::int64_t first;
  double fraction;

  // `coordinate` in texels of the level looked at; their middles are at halves.
  explicit Between(double coordinate)
      : first(static_cast<std::int64_t>(std::floor(coordinate - 0.5))),
        fraction(coordinate - 0.5 - static_cast<double>(first)) {}
};

inline std::int64_t texel_at(double coordinate) { return static_cast<std::int64_t>(std::floor(coordinate)); }

}  // namespace moire
