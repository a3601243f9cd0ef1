// The part of a picture that is worth magnifying.
#include "run/detail_window.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace moire {
namespace {

// sums(x, y) is the sum of all values left of x and above y.
class Sums {
 public:
  Sums(std::span<const double> values, ImageSize size)
      : stride_(static_cast<std::size_t>(size.width) + 1),
        sums_(stride_ * (static_cast<std::size_t>(size.height) + 1)) {
    std::size_t i = 0;
    for (std::size_t y = 1; y <= static_cast<std::size_t>(size.height); ++y) {
      double row = 0;
      for (std::size_t x = 1; x < stride_; ++x, ++i) {
        if (std::isfinite(values[i])) row += values[i];
        sums_[y * stride_ + x] = sums_[(y - 1) * stride_ + x] + row;
      }
    }
  }

  double of(int x, int y, int width, int height) const {
    return at(x + width, y + height) - at(x, y + height) - at(x + width, y) + at(x, y);
  }

 private:
  double at(int x, int y) const { return sums_[static_cast<std::size_t>(y) * stride_ + static_cast<std::size_t>(x)]; }

  std::size_t stride_;
  std::vector<double> sums_;
};

}  // namespace

std::array<int, 4> worst_window(std::span<const double> error, ImageSize size, int side) {
  const Sums sums(error, size);
  const int width = std::min(side, size.width), height = std::min(side, size.height);
  std::array<int, 4> worst{0, 0, width, height};
  double greatest = -HUGE_VAL;
  for (int y = 0; y + height <= size.height; ++y) {
    for (int x = 0; x + width <= size.width; ++x) {
      const double sum = sums.of(x, y, width, height);
      if (sum > greatest) {
        greatest = sum;
        worst = {x, y, width, height};
      }
    }
  }
  return worst;
}

std::array<int, 4> middle_window(ImageSize size, int side) {
  const int width = std::min(side, size.width), height = std::min(side, size.height);
  return {(size.width - width) / 2, (size.height - height) / 2, width, height};
}

}  // namespace moire
