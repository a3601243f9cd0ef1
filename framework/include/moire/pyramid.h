// Averages of a texture at ever lower resolution: mip-maps (Williams 1983, doi:10.1145/800059.801126).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace moire {

// Level l has max(1, w >> l) x max(1, h >> l) texels, the last one 1 x 1. Each texel is the exact average, in the
// texture's own (linear) light, of the part of level 0 that it covers: texel i of a row of w_l covers level-0 texels
// i w_0 / w_l to (i + 1) w_0 / w_l, whole or in part, so that all levels keep the mean whatever the sizes are.
// What is not a number makes all that it is part of none.
class Pyramid {
 public:
  struct Level {
    int width, height;
    double s_scale, t_scale;  // from texels of level 0 to those of this one: w_l / w_0, h_l / h_0
    std::vector<float> rgba;  // four floats a texel, the last one 0; rows follow each other
  };

  // `rgb`: red of texel (0, 0), texels `stride` floats apart. Takes about 21 bytes a texel.
  Pyramid(const float* rgb, std::size_t stride, int width, int height);

  int levels() const { return static_cast<int>(levels_.size()); }
  const Level& level(int l) const { return levels_[static_cast<std::size_t>(l)]; }

 private:
  std::vector<Level> levels_;
};

}  // namespace moire
