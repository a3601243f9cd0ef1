// Integrals of the texture along its rows or columns.
#pragma once

#include <cstdint>
#include <vector>

#include <moire/texture.h>

namespace textured_plane {

enum class Along { s, t };

// Of line n: F(x), the integral from 0 to x of its colour minus its mean. F is periodic and, between whole numbers,
// straight. Subtracting the mean keeps F as small as the texture's contrast, however far x is.
class LineSums {
 public:
  struct Node {
    double r, g, b, unused;
  };

  // `rgba`: four floats a texel. Takes 32 bytes a texel, twice that for mirrored textures. Requires: not clamped.
  LineSums(const float* rgba, int width, int height, Along along, moire::Wrap wrap);

  // F repeats itself after so many texels.
  int period() const { return period_; }
  // And so do the lines after so many of them.
  int repetition() const { return wrap_ == moire::Wrap::mirror ? 2 * lines_ : lines_; }
  // F at 0 .. period(), where it is 0 at both ends.
  const Node* line(std::int64_t n) const { return nodes_.data() + index(n) * (static_cast<std::size_t>(period_) + 1); }
  const Node& mean(std::int64_t n) const { return means_[index(n)]; }

 private:
  std::size_t index(std::int64_t n) const { return static_cast<std::size_t>(moire::wrapped(n, lines_, wrap_)); }

  moire::Wrap wrap_;
  int period_, lines_;
  std::vector<Node> nodes_, means_;
};

}  // namespace textured_plane
